package org.pendant.kit.table;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Font;
import java.awt.FontMetrics;
import org.junit.jupiter.api.Test;

final class MiddleElisionTest {
  /** All characters are ten pixels wide. */
  @SuppressWarnings("serial") // never written to a stream
  private static final FontMetrics TEN =
      new FontMetrics(new Font(Font.MONOSPACED, Font.PLAIN, 12)) {
        @Override
        public int stringWidth(String text) {
          return 10 * text.codePointCount(0, text.length());
        }
      };

  @Test
  void whatFitsStaysWhole() {
    assertEquals("APPROACH", MiddleElision.fit("APPROACH", TEN, 80));
  }

  @Test
  void whatIsTooLongKeepsItsBeginAndItsEnd() {
    assertEquals(
        "mass of\u2026part_12", MiddleElision.fit("mass of heavy_casting_part_12", TEN, 150));
    assertEquals("ab\u2026e", MiddleElision.fit("abcde", TEN, 40));
  }

  @Test
  void whereThereIsNoRoomOnlyTheMarkIsLeft() {
    assertEquals("\u2026", MiddleElision.fit("APPROACH", TEN, 15));
  }
}
