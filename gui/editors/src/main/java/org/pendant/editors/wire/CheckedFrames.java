package org.pendant.editors.wire;

import static org.pendant.editors.wire.FrameTexts.text;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.OptionalLong;
import java.util.function.Consumer;

/**
 * Checked frames: the bytes of a client without the frames that cannot be read: those that are too
 * long, and header lines that name no length. What is left out is told, and reading goes on behind
 * it.
 *
 * <p>A frame is a head of lines that end in CR LF, an empty line, and as many bytes as {@code
 * Content-Length} says (Language Server Protocol, base protocol).
 */
public final class CheckedFrames extends InputStream {
  /** The most bytes of one message. */
  public static final int MAX_MESSAGE = 64 << 20;

  /** The most bytes of the head of a message. */
  private static final int MAX_HEAD = 4096;

  private static final String LENGTH = "content-length:";

  private final InputStream input;
  private final Consumer<String> complaints;
  private byte[] head = new byte[0];
  private int headAt;
  private long bodyLeft;

  /**
   * Frames of {@code input}.
   *
   * @param complaints takes a sentence for each frame that is left out
   */
  public CheckedFrames(InputStream input, Consumer<String> complaints) {
    this.input = input;
    this.complaints = complaints;
  }

  @Override
  public int read() throws IOException {
    byte[] one = new byte[1];
    return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
  }

  @Override
  public int read(byte[] target, int offset, int length) throws IOException {
    if (length == 0) {
      return 0;
    }
    if (headAt == head.length && bodyLeft == 0 && !nextHead()) {
      return -1;
    }
    if (headAt < head.length) {
      int count = Math.min(length, head.length - headAt);
      System.arraycopy(head, headAt, target, offset, count);
      headAt += count;
      return count;
    }
    int count = input.read(target, offset, (int) Math.min(length, bodyLeft));
    bodyLeft = count < 0 ? 0 : bodyLeft - count;
    return count;
  }

  /** Reads on to the head of a frame that can be read; whether there is one. */
  private boolean nextHead() throws IOException {
    while (true) {
      OptionalLong length = OptionalLong.empty();
      boolean any = false;
      int size = 0;
      while (true) {
        String line = line();
        if (line == null) {
          return false;
        }
        if (line.isEmpty()) {
          break;
        }
        any = true;
        size += line.length();
        if (line.toLowerCase(Locale.ROOT).startsWith(LENGTH)) {
          length = number(line.substring(LENGTH.length()).strip());
        }
        if (size > MAX_HEAD) {
          complaints.accept(text("longHead", MAX_HEAD));
          length = OptionalLong.empty();
          any = false;
          size = 0;
        }
      }
      if (length.isPresent() && length.getAsLong() <= MAX_MESSAGE) {
        bodyLeft = length.getAsLong();
        head = ("Content-Length: " + bodyLeft + "\r\n\r\n").getBytes(StandardCharsets.US_ASCII);
        headAt = 0;
        return true;
      }
      if (length.isPresent()) {
        complaints.accept(text("longMessage", length.getAsLong(), MAX_MESSAGE));
        input.skipNBytes(length.getAsLong());
      } else if (any) {
        complaints.accept(text("noLength"));
      }
    }
  }

  private static OptionalLong number(String text) {
    boolean digits = !text.isEmpty() && text.length() <= 15;
    return digits && text.chars().allMatch(each -> each >= '0' && each <= '9')
        ? OptionalLong.of(Long.parseLong(text))
        : OptionalLong.empty();
  }

  /** The next line without its end, cut off where it is too long; null at the end. */
  private String line() throws IOException {
    ByteArrayOutputStream line = new ByteArrayOutputStream(32);
    while (true) {
      int next = input.read();
      if (next < 0) {
        return null;
      }
      if (next == '\n') {
        return line.toString(StandardCharsets.ISO_8859_1).stripTrailing();
      }
      if (line.size() <= MAX_HEAD) {
        line.write(next);
      }
    }
  }

  @Override
  public void close() throws IOException {
    input.close();
  }
}
