package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

final class ParagraphTest {

  @Test
  void linesBreakAtBlanks() {
    assertEquals(List.of("one two", "three", "four"), Paragraph.wrap("one two  three\nfour", 7));
  }

  @Test
  void wordLongerThanALineStaysWhole() {
    assertEquals(List.of("a", "extraordinary", "b"), Paragraph.wrap("a extraordinary b", 5));
  }
}
