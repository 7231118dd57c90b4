package org.pendant.motion.servo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.OptionalDouble;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.Joints;
import org.pendant.motion.MotionControl;
import org.pendant.motion.PlanningException;
import org.pendant.motion.StopJ;

/** The target of an arm that torques drive: it is where the arm is. */
class TorqueTargetTest {
  private static final Joints MOVED = Rig.READY.with(5, 0.2);
  private static final Joints TURNING = Joints.ZERO.with(5, 0.5);

  private final Rig rig = new Rig();
  private final MotionControl control = rig.control;

  /** A frame of torques, after which the arm turns. */
  @BeforeEach
  void drive() throws PlanningException {
    rig.servoing.giveTorque(Joints.ZERO, FrictionShare.MOST);
    control.step();
    control.guide(MOVED, TURNING);
  }

  @Test
  void followsTheArm() {
    assertTrue(control.torqueDriven());
    assertTrue(control.moving());
    assertEquals(MOVED, control.positionRad());
    assertEquals(TURNING, control.speedRadPerS());
    assertEquals(Joints.ZERO, control.accelerationRadPerS2());
  }

  @Test
  void withoutTorquesItComesToRestFromThere() {
    control.step();
    assertFalse(control.torqueDriven());
    assertEquals(0.2 + 0.5 * 0.002, control.positionRad().q5(), 2e-5);
    for (int i = 0; i < 40; i++) {
      control.step();
    }
    assertEquals(0.2 + 0.25 / 16, control.positionRad().q5(), 1e-9);
    assertFalse(control.moving());
  }

  @Test
  void inAHaltItStopsAsHardAsAsked() {
    control.halt(15);
    control.step();
    assertEquals(-15, control.accelerationRadPerS2().q5(), 1e-9);
  }

  @Test
  void aSpeedGoesOnFromThere() throws PlanningException {
    control.setSpeedFraction(0.5);
    control.continueWith(rig.servoing.speedJ(TURNING, 1, OptionalDouble.of(2)));
    control.step();
    assertFalse(control.torqueDriven());
    assertEquals(0.5, control.speedRadPerS().q5(), 0.02);
    for (int i = 0; i < 1500; i++) {
      control.step();
    }
    assertEquals(0.25, control.speedRadPerS().q5(), 1e-9);
  }

  @Test
  void withTheSliderAtZeroASpeedBringsItToRestWithoutAJump() throws PlanningException {
    control.setSpeedFraction(0);
    control.continueWith(rig.servoing.speedJ(TURNING, 1, OptionalDouble.of(2)));
    double before = 0.5;
    for (int i = 0; i < 100; i++) {
      control.step();
      double now = control.speedRadPerS().q5();
      assertTrue(before - now <= 0.02, before + " to " + now);
      before = now;
    }
    assertEquals(0, before);
  }

  @Test
  void whatBeginsAtRestIsRefused() {
    PlanningException error =
        assertThrows(PlanningException.class, () -> control.start((q, qd) -> new StopJ(q, qd, 1)));
    assertEquals("moving", error.code());
    assertTrue(error.getMessage().startsWith("direct_torque has left"), error.getMessage());
    assertThrows(PlanningException.class, () -> control.jumpTo(Rig.READY));
  }

  @Test
  void nobodyElseTakesItInAFrameThatHasItsTorques() throws PlanningException {
    rig.servoing.giveTorque(Joints.ZERO, FrictionShare.MOST);
    PlanningException error =
        assertThrows(
            PlanningException.class, () -> control.takeOver((q, qd) -> new StopJ(q, qd, 1)));
    assertEquals("robot-in-use", error.code());
    assertThrows(
        PlanningException.class, () -> rig.servoing.giveTorque(Joints.ZERO, FrictionShare.MOST));
    assertThrows(PlanningException.class, control::startGuidance);
  }

  @Test
  void aHandMayTakeItOver() throws PlanningException {
    control.startGuidance();
    assertFalse(control.torqueDriven());
    assertTrue(control.guided());
    assertThrows(
        PlanningException.class, () -> rig.servoing.giveTorque(Joints.ZERO, FrictionShare.MOST));
  }

  @Test
  void withoutPowerItIsOver() {
    control.adopt(Rig.READY);
    assertFalse(control.torqueDriven());
    assertFalse(control.moving());
    assertEquals(Rig.READY, control.positionRad());
  }
}
