package org.pendant.language.service;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

final class CharacterOffsetsTest {
  /** One, two, three and four bytes long, the last one two characters. */
  private static final String TEXT = "a\u00E9\u2254b\uD83D\uDE00c";

  @Test
  void everyCharacterHasTheOffsetOfItsFirstByte() {
    CharacterOffsets offsets = CharacterOffsets.of(TEXT);
    int[] starts = {0, 1, 2, 3, 4, 6, 7};
    for (int start : starts) {
      int bytes = TEXT.substring(0, start).getBytes(StandardCharsets.UTF_8).length;
      assertEquals(bytes, offsets.toByte(start));
      assertEquals(start, offsets.toCharacter(bytes));
    }
  }

  @Test
  void anOffsetInsideACharacterMeansItsStart() {
    CharacterOffsets offsets = CharacterOffsets.of(TEXT);
    assertEquals(1, offsets.toCharacter(2));
    assertEquals(2, offsets.toCharacter(5));
    assertEquals(4, offsets.toCharacter(9));
    assertEquals(7, offsets.toByte(5));
  }

  @Test
  void textInAsciiCountsAlike() {
    CharacterOffsets offsets = CharacterOffsets.of("abc");
    assertEquals(2, offsets.toByte(2));
    assertEquals(3, offsets.toCharacter(3));
  }

  @Test
  void offsetsOutsideTheTextAreRefused() {
    IllegalArgumentException refused =
        assertThrows(IllegalArgumentException.class, () -> CharacterOffsets.of("ab").toByte(3));
    assertEquals("character 3 is outside the text, expected 0 to 2", refused.getMessage());
  }
}
