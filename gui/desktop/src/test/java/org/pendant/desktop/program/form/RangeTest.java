package org.pendant.desktop.program.form;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.pendant.kit.form.Measure;

final class RangeTest {

  @Test
  void rangesSayWhatIsLegal() {
    assertEquals("", Range.upTo(0.25).refusal(0.25, Measure.MILLIMETRE_PER_S));
    assertEquals(
        "must be above 0 and at most 250 mm/s",
        Range.upTo(0.25).refusal(0, Measure.MILLIMETRE_PER_S));
    assertEquals("must be 0 s or more", Range.FROM_ZERO.refusal(-1, Measure.SECOND));
    assertEquals("must be 1 to 5", Range.of(1, 5).refusal(6, Measure.COUNT));
    assertEquals("must be above 0 s", Range.ABOVE_ZERO.refusal(Double.NaN, Measure.SECOND));
  }
}
