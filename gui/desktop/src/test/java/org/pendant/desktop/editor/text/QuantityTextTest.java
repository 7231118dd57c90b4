package org.pendant.desktop.editor.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.RotationForm;
import org.pendant.language.service.Quantity;
import org.pendant.language.signature.Unit;
import org.pendant.language.source.SourceRange;

final class QuantityTextTest {

  private static String text(double value, Unit unit) {
    return text(value, unit, PoseForm.STANDARD);
  }

  private static String text(double value, Unit unit, PoseForm form) {
    return QuantityText.of(new Quantity(new SourceRange(0, 1), value, unit, "a"), form);
  }

  @Test
  void theUnitsAreThoseThatPeopleHaveChosen() {
    PoseForm inches = new PoseForm(DisplayUnit.INCH, DisplayUnit.RADIAN, RotationForm.VECTOR);
    assertEquals("a: 0.0254 m/s = 1.0 in/s", text(0.0254, Unit.METRE_PER_SECOND, inches));
    assertEquals("a: 1.57 rad", text(1.57, Unit.RADIAN, inches));
    PoseForm metres = new PoseForm(DisplayUnit.METRE, DisplayUnit.DEGREE, RotationForm.VECTOR);
    assertEquals("a: 0.25 m", text(0.25, Unit.METRE, metres));
  }

  @Test
  void anglesAreShownInDegrees() {
    assertEquals("a: 1.57 rad = 90.0\u00b0", text(1.57, Unit.RADIAN));
    assertEquals("a: -0.01 rad/s = -0.573\u00b0/s", text(-0.01, Unit.RADIAN_PER_SECOND));
    assertEquals(
        "a: 1.4 rad/s\u00b2 = 80.2\u00b0/s\u00b2", text(1.4, Unit.RADIAN_PER_SECOND_SQUARED));
    assertEquals("a: 180 deg = 3.1416 rad", text(180, Unit.DEGREE));
  }

  @Test
  void lengthsAreShownInMillimetres() {
    assertEquals("a: 0.25 m = 250.0 mm", text(0.25, Unit.METRE));
    assertEquals("a: 0.5 m/s = 500.0 mm/s", text(0.5, Unit.METRE_PER_SECOND));
  }

  @Test
  void otherUnitsStayAsTheyAre() {
    assertEquals("a: 2.5 kg", text(2.5, Unit.KILOGRAM));
    assertEquals("a: 0.5 s = 500.0 ms", text(0.5, Unit.SECOND));
  }
}
