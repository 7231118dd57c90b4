package org.pendant.kit.form;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

final class MeasureTest {
  @Test
  void writesWithoutNeedlessDecimals() {
    assertEquals("60", Measure.DEGREE_PER_S.text(Math.toRadians(60)));
    assertEquals("12.5", Measure.MILLIMETRE.text(0.0125));
    assertEquals("0", Measure.MILLIMETRE.text(-1e-9));
    assertEquals("100 N", Measure.NEWTON.words(100));
  }

  @Test
  void limitsHaveFewDigitsAndAreNotMadeLarger() {
    assertEquals("3.141", Measure.RADIAN_PER_S.brief(Math.PI));
    assertEquals("40", Measure.RADIAN_PER_S2.brief(40));
    assertEquals("12.5", Measure.MILLIMETRE.brief(0.0125));
    assertEquals("196", Measure.INCH_PER_S.brief(5));
    assertEquals("-6.335", Measure.RADIAN.brief(-6.335545));
    assertEquals("0", Measure.MILLIMETRE.brief(0));
  }

  @Test
  void readsPointsCommasAndUnits() {
    assertEquals(0.0125, Measure.MILLIMETRE.parse("12,5"), 1e-12);
    assertEquals(0.0125, Measure.MILLIMETRE.parse(" 12.5 mm "), 1e-12);
    assertEquals(Math.PI, Measure.DEGREE.parse("180\u00b0"), 1e-12);
    assertEquals(1.2, Measure.MILLIMETRE_PER_S2.parse("1200 mm/s2"), 1e-12);
  }

  @Test
  void refusesOtherUnits() {
    assertEquals(
        "unit is 's', must be mm",
        assertThrows(IllegalArgumentException.class, () -> Measure.MILLIMETRE.parse("1 s"))
            .getMessage());
  }

  @Test
  void countsAreWhole() {
    assertEquals(3, Measure.COUNT.parse("3"));
    assertEquals(
        "'2.5' is not a whole number",
        assertThrows(IllegalArgumentException.class, () -> Measure.COUNT.parse("2.5"))
            .getMessage());
  }
}
