package org.pendant.project.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

final class NumberRangeTest {
  @Test
  void saysWhatIsLegal() {
    assertEquals(
        "must be above 0 and at most 250 mm/s",
        NumberRange.upTo(0.25).words(FieldUnit.MILLIMETRE_PER_S));
    assertEquals("must be 1 to 5", NumberRange.of(1, 5).words(FieldUnit.COUNT));
    assertEquals("must be -1000 to 1000 mm", NumberRange.within(1).words(FieldUnit.MILLIMETRE));
    assertEquals("must be a number", NumberRange.ANY.words(FieldUnit.SECOND));
  }

  @Test
  void itsEndsAreLegalUnlessItIsOpen() {
    assertTrue(NumberRange.upTo(0.25).contains(0.25));
    assertFalse(NumberRange.upTo(0.25).contains(0));
    assertTrue(NumberRange.of(0, 1).contains(0));
    assertFalse(NumberRange.of(0, 1).contains(1.001));
  }

  @Test
  void whatIsNoNumberIsNeverLegal() {
    assertFalse(NumberRange.ANY.contains(Double.NaN));
    assertFalse(NumberRange.ANY.contains(Double.NEGATIVE_INFINITY));
    assertTrue(NumberRange.ANY.contains(-Double.MAX_VALUE));
  }
}
