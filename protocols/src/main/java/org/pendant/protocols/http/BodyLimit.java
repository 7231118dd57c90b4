package org.pendant.protocols.http;

import java.util.Optional;

/**
 * Body limit: how large the body of a request may be.
 *
 * @param keptBytes of a larger one nothing is kept, and the request is refused
 * @param readBytes with a larger one the client is disconnected at once
 * @param room for those with more than {@link #USUAL_BYTES}
 */
public record BodyLimit(int keptBytes, int readBytes, Optional<LargeBodies> room) {
  /** Most bytes of usual bodies; these have a few hundred. */
  static final int USUAL_BYTES = 65_536;

  /** The one that most requests have. */
  public static final BodyLimit USUAL = new BodyLimit(USUAL_BYTES, USUAL_BYTES, Optional.empty());
}
