package org.pendant.protocols.egress;

import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.protocols.net.WireTap;
import org.pendant.protocols.wire.Dissector;

/**
 * Traced: what is told of the connections that a policy makes.
 *
 * @param name what connects, such as {@code Script socket}
 * @param dissector reads a connection for people, a new one for each
 * @param tap what listens now, if anything does
 */
public record Traced(String name, Supplier<Dissector> dissector, Supplier<Optional<WireTap>> tap) {
  /** Nobody listens. */
  static final Traced NOT = new Traced("", Dissector::raw, Optional::empty);
}
