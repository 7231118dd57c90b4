package org.pendant.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

final class TerminalColumnsTest {

  @Test
  void lettersOfLatinAndSignsOfUnitsTakeOneColumnEach() {
    assertEquals(0, TerminalColumns.of(""));
    assertEquals(6, TerminalColumns.of("kg m/s"));
    assertEquals(11, TerminalColumns.of("größer ²°µ…"));
  }

  @Test
  void chineseCharactersAndFullWidthPunctuationTakeTwo() {
    assertEquals(4, TerminalColumns.of("端口"));
    assertEquals(16, TerminalColumns.of("端口 29999：空闲"));
    assertEquals(6, TerminalColumns.of("，。（"));
  }

  @Test
  void ideographsOutsideTheBasicPlaneTakeTwoThoughTheyAreTwoChars() {
    assertEquals(2, TerminalColumns.of("\uD840\uDC00"));
  }

  @Test
  void aMarkOnTheLetterBeforeItTakesNone() {
    assertEquals(1, TerminalColumns.of("u\u0308"));
  }
}
