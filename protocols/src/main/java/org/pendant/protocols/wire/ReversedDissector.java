package org.pendant.protocols.wire;

import java.nio.ByteBuffer;

/**
 * Reversed dissector: of connections that this side has made: it asks, and the peer answers. What
 * is asked has its effects elsewhere.
 *
 * @param served reads connections that peers have made
 */
public record ReversedDissector(Dissector served) implements Dissector {
  private static Direction other(Direction direction) {
    return direction == Direction.IN ? Direction.OUT : Direction.IN;
  }

  @Override
  public int length(Direction direction, ByteBuffer bytes) {
    return served.length(other(direction), bytes);
  }

  @Override
  public Reading read(Direction direction, ByteBuffer message) {
    return served.read(other(direction), message).doingNothing();
  }
}
