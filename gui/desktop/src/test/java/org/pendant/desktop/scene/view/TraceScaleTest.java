package org.pendant.desktop.scene.view;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.pendant.desktop.scene.Models;
import org.pendant.desktop.scene.TcpTrace;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.RotationForm;
import org.pendant.models.pose.Pose;

final class TraceScaleTest {
  private static final TcpTrace TRACE = Models.trace(Pose.ZERO, 1);

  private static TraceScale in(DisplayUnit length) {
    return TraceScale.of(TRACE, new PoseForm(length, DisplayUnit.DEGREE, RotationForm.VECTOR));
  }

  @Test
  void speedsAreInTheUnitThatPeopleHaveChosen() {
    assertEquals(new TraceScale("0", "25", "100 mm/s"), in(DisplayUnit.MILLIMETRE));
    assertEquals(new TraceScale("0", "0.025", "0.1 m/s"), in(DisplayUnit.METRE));
    assertEquals(new TraceScale("0", "0.984", "3.94 in/s"), in(DisplayUnit.INCH));
  }
}
