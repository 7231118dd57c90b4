package org.pendant.desktop.scene.view;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.pendant.desktop.scene.Models;
import org.pendant.desktop.scene.TcpTrace;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.RotationForm;
import org.pendant.models.pose.Pose;
import org.pendant.recording.lines.Margin;

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

  @Test
  void aMarginIsToldInTheUnitOfItsLimit() {
    PoseForm degrees = PoseForm.STANDARD;
    PoseForm inches = new PoseForm(DisplayUnit.INCH, DisplayUnit.RADIAN, RotationForm.VECTOR);
    assertEquals("torque 62 %", TraceScale.margin(Margin.TORQUE, 0.24, degrees));
    assertEquals(
        "joint limit: 12\u00b0 away", TraceScale.margin(Margin.JOINT_LIMIT, 33.0 / 45, degrees));
    assertEquals("joint limit: 0.393 rad away", TraceScale.margin(Margin.JOINT_LIMIT, 0.5, inches));
    assertEquals("safety plane: 50 mm away", TraceScale.margin(Margin.PLANE, 0.75, degrees));
    assertEquals("safety plane: 1.97 in away", TraceScale.margin(Margin.PLANE, 0.75, inches));
  }

  @Test
  void aMarginThatIsNotUsedAtAllOrWhollyIsToldAsABound() {
    assertEquals(
        "joint speed \u2264 50 %", TraceScale.margin(Margin.JOINT_SPEED, 0, PoseForm.STANDARD));
    assertEquals(
        "tool speed \u2265 100 %", TraceScale.margin(Margin.TOOL_SPEED, 1, PoseForm.STANDARD));
    assertEquals(
        "joint limit: \u2265 45\u00b0 away",
        TraceScale.margin(Margin.JOINT_LIMIT, 0, PoseForm.STANDARD));
    assertEquals(
        "safety plane: \u2264 0 mm away", TraceScale.margin(Margin.PLANE, 1, PoseForm.STANDARD));
  }
}
