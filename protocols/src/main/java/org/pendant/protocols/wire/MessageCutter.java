package org.pendant.protocols.wire;

import java.nio.ByteBuffer;
import java.util.function.BiConsumer;

/**
 * Message cutter: the bytes of one direction of a connection as messages, by its dissector. What is
 * not of the protocol is handed on as it came.
 */
public final class MessageCutter {
  /** Longer messages are handed on in pieces. */
  public static final int MAX_BYTES = 1 << 20;

  private final Direction direction;
  private final Dissector dissector;
  private final BiConsumer<Reading, ByteBuffer> messages;
  private ByteBuffer begun = ByteBuffer.allocate(0);

  /** Nothing has come yet. */
  public MessageCutter(
      Direction direction, Dissector dissector, BiConsumer<Reading, ByteBuffer> messages) {
    this.direction = direction;
    this.dissector = dissector;
    this.messages = messages;
  }

  /**
   * Takes bytes, cut anywhere.
   *
   * @param bytes not changed any more by the caller
   */
  public void take(ByteBuffer bytes) {
    ByteBuffer all = bytes;
    if (begun.hasRemaining()) {
      all = ByteBuffer.allocate(begun.remaining() + bytes.remaining());
      all.put(begun).put(bytes.duplicate()).flip();
    }
    begun = rest(all.asReadOnlyBuffer());
  }

  /** Hands on the messages that are whole; answers the bytes of one that has begun. */
  private ByteBuffer rest(ByteBuffer all) {
    while (all.hasRemaining()) {
      int length = dissector.length(direction, all);
      boolean strange = length == Dissector.UNKNOWN || length > MAX_BYTES;
      boolean tooLong = length == Dissector.MORE && all.remaining() > MAX_BYTES;
      if (strange || tooLong) {
        hand(Dissector.unread(all), all.slice());
        return ByteBuffer.allocate(0);
      }
      if (length == Dissector.MORE || length > all.remaining()) {
        return all;
      }
      ByteBuffer message = all.slice(all.position(), length);
      all.position(all.position() + length);
      hand(read(message), message);
    }
    return all;
  }

  private void hand(Reading reading, ByteBuffer message) {
    messages.accept(reading, message);
  }

  private Reading read(ByteBuffer message) {
    try {
      return dissector.read(direction, message.duplicate());
    } catch (RuntimeException e) {
      // peers send what they like
      return Dissector.unread(message);
    }
  }

  /** Bytes have been missed: what had begun is handed on as it is. */
  public void missed() {
    if (begun.hasRemaining()) {
      hand(Dissector.unread(begun), begun);
      begun = ByteBuffer.allocate(0);
    }
  }
}
