package org.pendant.desktop.log;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** With characters that are one wide. */
final class LineBreakerTest {

  private static List<String> lines(String text, int width) {
    return LineBreaker.lines(text, String::length, width, LineBreaker.MAX_LINES);
  }

  @Test
  void linesBreakAtBlanks() {
    assertEquals(List.of("the arm", "is", "stopped"), lines("the arm is stopped", 8));
    assertEquals(List.of("fits"), lines("fits", 4));
  }

  @Test
  void aWordThatIsTooLongIsBroken() {
    assertEquals(List.of("abcd", "efgh", "i j"), lines("abcdefghi j", 4));
  }

  @Test
  void lineEndsStay() {
    assertEquals(List.of("a", "", "b"), lines("a\n\nb", 9));
  }

  @Test
  void veryLongTextsEndInAMark() {
    List<String> lines = lines("x ".repeat(100_000), 10);
    assertEquals(LineBreaker.MAX_LINES, lines.size());
    assertEquals("\u2026", lines.getLast());
  }

  @Test
  void noCharacterIsLostAndNoLineTooLong() {
    SplittableRandom random = new SplittableRandom(5);
    for (int i = 0; i < 1000; i++) {
      StringBuilder text = new StringBuilder();
      for (int word = random.nextInt(1, 12); word > 0; word--) {
        text.append("w".repeat(random.nextInt(1, 15))).append(' ');
      }
      int width = random.nextInt(2, 20);
      List<String> lines = lines(text.toString(), width);
      assertEquals(
          text.toString().replace(" ", ""),
          String.join("", lines).replace(" ", ""),
          () -> "of '" + text + "' in " + width);
      assertTrue(lines.stream().allMatch(each -> each.length() <= width), () -> "of " + text);
    }
  }
}
