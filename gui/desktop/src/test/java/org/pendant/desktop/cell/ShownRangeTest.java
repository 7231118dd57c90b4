package org.pendant.desktop.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.Measures;

final class ShownRangeTest {
  @Test
  void lengthsAreInTheMeasureThatPeopleTypeIn() {
    String refusal = "pose[0] is -12.5 m, must be -10 to 10 m";
    assertEquals(
        "pose[0] is -12500 mm, must be -10000 to 10000 mm", ShownRange.of(refusal, Measures.USUAL));
    assertEquals(refusal, ShownRange.of(refusal, usual -> Measure.METRE));
  }

  @Test
  void otherThingsStay() {
    String mass = "mass is 500 kg, must be 0 to 100 kg";
    assertEquals(mass, ShownRange.of(mass, Measures.USUAL));
    String stiffness = "stiffness is 1 N/m, must be 100 to 1000000 N/m";
    assertEquals(stiffness, ShownRange.of(stiffness, Measures.USUAL));
  }
}
