package org.pendant.protocols.wire;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/**
 * Dissector: cuts the messages of one connection out of its bytes, and reads them. It may remember
 * what peers have agreed on. One thread at a time.
 */
public interface Dissector {
  /** The answer to {@link #length} where more bytes are needed. */
  int MORE = 0;

  /** The answer to {@link #length} where the bytes are not of the protocol. */
  int UNKNOWN = -1;

  /**
   * How long the message at the position of {@code bytes} is.
   *
   * @param bytes at least one; big-endian; the position is not to be moved
   * @return bytes of the whole message, which may be more than there are; {@link #MORE} or {@link
   *     #UNKNOWN}
   */
  int length(Direction direction, ByteBuffer bytes);

  /**
   * Reads a message.
   *
   * @param message all of it and no more, big-endian, read-only; kept by the reading perhaps
   * @throws RuntimeException if it is not of the protocol
   */
  Reading read(Direction direction, ByteBuffer message);

  /** A dissector of bytes that mean nothing here. */
  static Dissector raw() {
    return new Dissector() {
      @Override
      public int length(Direction direction, ByteBuffer bytes) {
        return bytes.remaining();
      }

      @Override
      public Reading read(Direction direction, ByteBuffer message) {
        return unread(message);
      }
    };
  }

  /** What can be said of any bytes: how many, and the text if they are one. */
  static Reading unread(ByteBuffer message) {
    String text = text(message);
    boolean printable = text.chars().allMatch(each -> each >= ' ' || Character.isWhitespace(each));
    return printable
        ? Reading.quoting("text", text.strip(), () -> Fields.of("text", text))
        : Reading.of("bytes", WireTexts.text("bytes", message.remaining()));
  }

  /** The text of a message, a character a byte. */
  static String text(ByteBuffer message) {
    return StandardCharsets.ISO_8859_1.decode(message.duplicate()).toString();
  }
}
