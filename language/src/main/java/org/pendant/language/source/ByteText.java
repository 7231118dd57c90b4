package org.pendant.language.source;

import java.nio.charset.StandardCharsets;

/**
 * Byte text: the two kinds of text that meet in a message. Scripts are bytes (manual 3), held one
 * {@code char} a byte; our own words are ordinary text.
 */
public final class ByteText {
  private ByteText() {}

  /**
   * {@code text} for people to read: characters that together are the bytes of a UTF-8 sequence
   * become the character that they encode, all others stay. So a message may quote a script in the
   * middle of words such as {@code m/s²}.
   */
  public static String decoded(String text) {
    StringBuilder decoded = new StringBuilder(text.length());
    int i = 0;
    while (i < text.length()) {
      int length = sequenceLength(text, i);
      if (length > 1) {
        byte[] sequence = text.substring(i, i + length).getBytes(StandardCharsets.ISO_8859_1);
        decoded.append(new String(sequence, StandardCharsets.UTF_8));
      } else {
        decoded.append(text, i, i + length);
      }
      i += length;
    }
    return decoded.toString();
  }

  /** The bytes of {@code text} in UTF-8, one {@code char} a byte, as scripts hold them. */
  public static String asBytes(String text) {
    return new String(text.getBytes(StandardCharsets.UTF_8), StandardCharsets.ISO_8859_1);
  }

  /** How many characters from {@code start} are the bytes of one UTF-8 sequence, or 1. */
  private static int sequenceLength(String text, int start) {
    char first = text.charAt(start);
    int length;
    if (first >= 0xC2 && first < 0xE0) {
      length = 2;
    } else if (first >= 0xE0 && first < 0xF0) {
      length = 3;
    } else if (first >= 0xF0 && first < 0xF5) {
      length = 4;
    } else {
      return 1;
    }
    if (start + length > text.length()) {
      return 1;
    }
    for (int i = start + 1; i < start + length; i++) {
      if (text.charAt(i) < 0x80 || text.charAt(i) > 0xBF) {
        return 1;
      }
    }
    return length;
  }
}
