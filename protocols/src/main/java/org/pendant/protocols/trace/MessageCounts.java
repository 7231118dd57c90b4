package org.pendant.protocols.trace;

import org.pendant.protocols.wire.Direction;

/**
 * Message counts of a client.
 *
 * @param in how many have come
 * @param out how many went
 */
public record MessageCounts(long in, long out) {
  /** Of a client that has said nothing. */
  public static final MessageCounts NONE = new MessageCounts(0, 0);

  MessageCounts and(WireMessage message) {
    return message.direction() == Direction.IN
        ? new MessageCounts(in + 1, out)
        : new MessageCounts(in, out + 1);
  }
}
