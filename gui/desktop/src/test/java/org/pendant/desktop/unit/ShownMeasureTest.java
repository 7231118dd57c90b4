package org.pendant.desktop.unit;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.kit.form.Measure;

final class ShownMeasureTest {
  private static PoseForm form(DisplayUnit length, DisplayUnit angle) {
    return new PoseForm(length, angle, RotationForm.VECTOR);
  }

  private static List<String> symbols(PoseForm form, Measure... usual) {
    return Arrays.stream(usual).map(each -> ShownMeasure.of(each, form).symbol()).toList();
  }

  @Test
  void lengthsAndSpeedsAreInOneUnit() {
    Measure[] usual = {
      Measure.MILLIMETRE, Measure.MILLIMETRE_PER_S, Measure.MILLIMETRE_PER_S2, Measure.DEGREE
    };
    assertEquals(List.of("mm", "mm/s", "mm/s\u00b2", "deg"), symbols(PoseForm.STANDARD, usual));
    assertEquals(
        List.of("in", "in/s", "in/s\u00b2", "deg"),
        symbols(form(DisplayUnit.INCH, DisplayUnit.DEGREE), usual));
    assertEquals(
        List.of("m", "m/s", "m/s\u00b2", "rad"),
        symbols(form(DisplayUnit.METRE, DisplayUnit.RADIAN), usual));
  }

  @Test
  void anglesAreToo() {
    assertEquals(
        List.of("rad", "rad/s", "rad/s\u00b2"),
        symbols(
            form(DisplayUnit.MILLIMETRE, DisplayUnit.RADIAN),
            Measure.DEGREE,
            Measure.DEGREE_PER_S,
            Measure.DEGREE_PER_S2));
  }

  @Test
  void whatIsNeitherStaysAsItIs() {
    PoseForm form = form(DisplayUnit.INCH, DisplayUnit.RADIAN);
    for (Measure each : Measure.values()) {
      if (!each.symbol().startsWith("mm") && !each.symbol().startsWith("deg")) {
        assertEquals(each, ShownMeasure.of(each, form));
      }
    }
  }

  @Test
  void aNumberIsTheSameInEachOfThem() {
    PoseForm form = form(DisplayUnit.INCH, DisplayUnit.RADIAN);
    assertEquals(0.254, ShownMeasure.of(Measure.MILLIMETRE_PER_S, form).parse("10 in/s"), 1e-12);
    assertEquals("1.5708", ShownMeasure.of(Measure.DEGREE, form).text(1.5708));
  }
}
