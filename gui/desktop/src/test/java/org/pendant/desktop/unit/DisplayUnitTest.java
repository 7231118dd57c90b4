package org.pendant.desktop.unit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

/** Numbers as people type and read them. */
final class DisplayUnitTest {

  private static String problem(DisplayUnit unit, String text) {
    return assertThrows(IllegalArgumentException.class, () -> unit.parse(text)).getMessage();
  }

  @Test
  void aNumberIsInTheUnitOfItsField() {
    assertEquals(0.0125, DisplayUnit.MILLIMETRE.parse("12.5"), 1e-15);
    assertEquals(12.5, DisplayUnit.METRE.parse(" 12.5 "));
    assertEquals(Math.PI / 2, DisplayUnit.DEGREE.parse("90"), 1e-15);
    assertEquals(-2e-3, DisplayUnit.MILLIMETRE.parse("-.2e1"), 1e-15);
  }

  @Test
  void aUnitBehindTheNumberCounts() {
    assertEquals(0.0125, DisplayUnit.METRE.parse("12.5 mm"), 1e-15);
    assertEquals(0.0254, DisplayUnit.MILLIMETRE.parse("1in"), 1e-15);
    assertEquals(Math.PI / 2, DisplayUnit.RADIAN.parse("90 deg"), 1e-15);
    assertEquals(Math.PI / 2, DisplayUnit.RADIAN.parse("90\u00b0"), 1e-15);
    assertEquals(0.25, DisplayUnit.KILOGRAM.parse("250 g"), 1e-15);
  }

  @Test
  void aCommaIsADecimalPoint() {
    assertEquals(1.5, DisplayUnit.METRE.parse("1,5"));
    assertEquals(0.0015, DisplayUnit.METRE.parse("1,5 mm"), 1e-15);
  }

  @Test
  void whatIsNoNumberIsRefusedWithASentence() {
    assertEquals("empty, must be a number in mm", problem(DisplayUnit.MILLIMETRE, " "));
    assertEquals(
        "'abc' is not a number; write for instance 12.5 or 12.5 deg",
        problem(DisplayUnit.DEGREE, "abc"));
    assertEquals("unit is 'kg', must be mm or m or in", problem(DisplayUnit.MILLIMETRE, "3 kg"));
    assertEquals("unit is ',5', must be kg or g", problem(DisplayUnit.KILOGRAM, "1,000,5"));
  }

  @Test
  void textHasAsManyDecimalsAsMatter() {
    assertEquals("12.50", DisplayUnit.MILLIMETRE.text(0.0125));
    assertEquals("0.01250", DisplayUnit.METRE.text(0.0125));
    assertEquals("-90.000", DisplayUnit.DEGREE.text(-Math.PI / 2));
    assertEquals("0.00", DisplayUnit.MILLIMETRE.text(-1e-9), "no minus before zero");
  }

  @Test
  void whatIsMeasuredHasTwoDecimalsInDegreesAndNoMinusBeforeZero() {
    assertEquals("90.00\u00b0", DisplayUnit.DEGREE.reading(Math.PI / 2));
    assertEquals("0.00\u00b0", DisplayUnit.DEGREE.reading(-1e-9));
    assertEquals("-0.06 mm", DisplayUnit.MILLIMETRE.reading(-0.00005795));
    assertEquals("1.57080 rad", DisplayUnit.RADIAN.reading(Math.PI / 2));
  }
}
