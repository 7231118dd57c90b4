package org.pendant.language.service;

import java.util.Arrays;

/**
 * Character offsets: converts between the characters of an editor's text and the bytes of a {@link
 * org.pendant.language.source.Source} made from it. An offset inside a character means its start.
 */
public final class CharacterOffsets {
  private final int length;

  // For each character outside ASCII: where it starts, and the bytes beyond one a character up to
  // its end.
  private final int[] starts;
  private final int[] ends;
  private final int[] extraBytes;

  private CharacterOffsets(int length, int[] starts, int[] ends, int[] extraBytes) {
    this.length = length;
    this.starts = starts;
    this.ends = ends;
    this.extraBytes = extraBytes;
  }

  /** The offsets of {@code text}, whose bytes are its UTF-8 form. */
  public static CharacterOffsets of(String text) {
    int count = (int) text.codePoints().filter(point -> point >= 0x80).count();
    int[] starts = new int[count];
    int[] ends = new int[count];
    int[] extraBytes = new int[count];
    int found = 0;
    int extra = 0;
    for (int i = 0; found < count; ) {
      int point = text.codePointAt(i);
      int characters = Character.charCount(point);
      if (point >= 0x80) {
        extra += bytes(point) - characters;
        starts[found] = i;
        ends[found] = i + characters;
        extraBytes[found++] = extra;
      }
      i += characters;
    }
    return new CharacterOffsets(text.length(), starts, ends, extraBytes);
  }

  /** The byte offset of {@code character}, 0 to the length of the text. */
  public int toByte(int character) {
    if (character < 0 || character > length) {
      throw new IllegalArgumentException(
          "character " + character + " is outside the text, expected 0 to " + length);
    }
    int found = Arrays.binarySearch(starts, character);
    int before = found >= 0 ? found : -found - 1;
    if (before > 0 && ends[before - 1] > character) {
      return toByte(starts[before - 1]);
    }
    return character + (before == 0 ? 0 : extraBytes[before - 1]);
  }

  /** The character that holds the byte at {@code offset}; the text's length after the last. */
  public int toCharacter(int offset) {
    int low = 0;
    int high = starts.length;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (ends[middle] + extraBytes[middle] <= offset) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    int plain = offset - (low == 0 ? 0 : extraBytes[low - 1]);
    int limit = low < starts.length ? starts[low] : length;
    return Math.clamp(plain, 0, limit);
  }

  private static int bytes(int point) {
    if (point < 0x800) {
      return 2;
    }
    // A lone surrogate becomes a question mark of one byte.
    boolean lone = point >= Character.MIN_SURROGATE && point <= Character.MAX_SURROGATE;
    return lone ? 1 : point < 0x10000 ? 3 : 4;
  }
}
