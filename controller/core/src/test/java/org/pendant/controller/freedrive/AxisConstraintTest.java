package org.pendant.controller.freedrive;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.pendant.controller.box.BoxSetup;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.pose.Pose;

class AxisConstraintTest {
  private static final double[] START = BoxSetup.START_RAD.toArray();
  private static final double[] AT_REST = new double[Joints.COUNT];

  /** Turning the base moves the tool of this arm about this far, m for each rad. */
  private static final double LEVER_M = 0.49;

  private static final FreeAxes ALL_BUT_Y = FreeAxes.ALL.with(1, false);

  private final ArmDescription arm = ArmLibrary.load("ur5e");
  private final AxisConstraint lock = new AxisConstraint(arm, new ArmDynamics(arm));

  private double[] torque(double[] q) {
    double[] torque = new double[Joints.COUNT];
    lock.add(q, AT_REST, torque);
    return torque;
  }

  /** What the base feels when the tool has been moved along y by turning it, Nm. */
  private double baseNm(double movedM) {
    double[] q = START.clone();
    q[0] += movedM / LEVER_M;
    return torque(q)[0];
  }

  @Test
  void freeAxesAskNothingOfAnyJoint() {
    lock.begin(FreeAxes.ALL, FreedriveFrame.BASE, Pose.ZERO, START);
    assertFalse(lock.locks());
    assertArrayEquals(AT_REST, torque(new double[] {1, 1, 1, 1, 1, 1}));
  }

  @Test
  void aLockedAxisIsPushedBackTheHarderTheFartherItIs() {
    lock.begin(ALL_BUT_Y, FreedriveFrame.BASE, Pose.ZERO, START);
    assertTrue(lock.locks());
    assertEquals(0, baseNm(0), 1e-9);
    double little = baseNm(-0.001);
    double more = baseNm(-0.002);
    assertTrue(Math.abs(more) > 1.7 * Math.abs(little), little + " and " + more);
    assertTrue(Math.signum(little) != Math.signum(baseNm(0.002)));
  }

  @Test
  void aLockThatIsForcedOpenSlipsAndHoldsWhereItHasBeenLeft() {
    lock.begin(ALL_BUT_Y, FreedriveFrame.BASE, Pose.ZERO, START);
    double atSlip = Math.abs(baseNm(0.005));
    double farAway = Math.abs(baseNm(0.05));
    assertEquals(1, farAway / atSlip, 0.1);
    assertTrue(Math.abs(baseNm(0.045)) < 0.15 * atSlip, "does not pull back to the beginning");
  }

  @Test
  void turnsOfAFreeAxisAddUpToNothing() {
    lock.begin(
        new FreeAxes(true, true, true, false, false, true), FreedriveFrame.BASE, Pose.ZERO, START);
    double[] q = START.clone();
    for (int i = 0; i < 4000; i++) {
      q[0] += 0.005;
      double[] torque = torque(q);
      for (double each : torque) {
        assertEquals(0, each, 1e-3, "after " + i + " steps");
      }
    }
  }

  @Test
  void anotherToolIsHeldWhereItIs() {
    lock.begin(
        new FreeAxes(false, false, false, true, true, true), FreedriveFrame.BASE, Pose.ZERO, START);
    lock.setTool(new Pose(0, 0, 0.2, 0, 0, 0), START);
    for (double each : torque(START)) {
      assertEquals(0, each, 1e-9);
    }
  }
}
