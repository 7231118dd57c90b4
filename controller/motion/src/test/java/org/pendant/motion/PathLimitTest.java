package org.pendant.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.time.FrameTime;

/** Motions that something slows down, halts or ends. */
final class PathLimitTest {
  private static final Joints START =
      new Joints(0, -Math.PI / 2, -Math.PI / 2, -Math.PI / 2, Math.PI / 2, 0);

  private final ArmDescription arm = ArmLibrary.load("ur5e");
  private final ForwardKinematics forward = new ForwardKinematics(arm);

  /** At most so fast, rad/s, whatever the plan says. */
  private static PathLimiter fastestJoint(double speedRadPerS) {
    return (q, qd) -> {
      double fastest = 0;
      for (double each : qd) {
        fastest = Math.max(fastest, Math.abs(each));
      }
      return speedRadPerS / fastest;
    };
  }

  private MotionPlan turnBase(double goalRad, double speedRadPerS) {
    Joints goal = START.with(0, goalRad);
    MoveLimits limits = new MoveLimits(2, speedRadPerS, 0);
    return (from, speed) -> new MoveJ(arm, from, goal, forward.tcpPose(goal, Pose.ZERO), limits);
  }

  @Test
  void aLimitedMoveKeepsTheLimitAndStillMeetsItsGoal() throws PlanningException {
    MotionControl control = new MotionControl(arm, START, fastestJoint(0.5));
    MotionTicket ticket = control.start(turnBase(1, 2));
    int frames = 0;
    double fastest = 0;
    Joints before = START;
    while (!ticket.finished()) {
      control.step();
      frames++;
      double moved = control.positionRad().maxAbsDifference(before) / FrameTime.FRAME_S;
      fastest = Math.max(fastest, Math.max(moved, control.speedRadPerS().get(0)));
      before = control.positionRad();
      assertTrue(ticket.failure().isEmpty());
    }
    assertEquals(0.5, fastest, 1e-3);
    assertEquals(START.with(0, 1), control.positionRad());
    assertTrue(frames > 1000, "1 rad at 0.5 rad/s takes two seconds");
  }

  @Test
  void aLimitThatIsNotReachedChangesNothing() throws PlanningException {
    MotionControl limited = new MotionControl(arm, START, fastestJoint(3));
    MotionControl free = new MotionControl(arm, START);
    MotionTicket ticket = limited.start(turnBase(1, 1));
    free.start(turnBase(1, 1));
    while (!ticket.finished()) {
      limited.step();
      free.step();
      assertEquals(free.positionRad(), limited.positionRad());
    }
  }

  @Test
  void aPathThatWouldHaveToRunTooSlowlyFails() throws PlanningException {
    MotionControl control = new MotionControl(arm, START, fastestJoint(0.001));
    MotionTicket ticket = control.start(turnBase(1, 1));
    for (int i = 0; i < 1000 && ticket.failure().isEmpty(); i++) {
      control.step();
    }
    MotionFailure failure = ticket.failure().orElseThrow();
    assertEquals("singularity", failure.code());
    assertTrue(failure.message().contains("joint 0"), failure.message());
  }

  @Test
  void aHaltStopsOnThePathWithItsOwnDeceleration() throws PlanningException {
    MotionControl control = new MotionControl(arm, START);
    MotionTicket ticket = control.start(turnBase(2, 1));
    while (control.speedRadPerS().get(0) < 1) {
      control.step();
    }
    double begin = control.positionRad().get(0);
    control.halt(15);
    int frames = 0;
    while (!control.speedRadPerS().equals(Joints.ZERO)) {
      control.step();
      frames++;
    }
    assertEquals(1 / 15.0 / FrameTime.FRAME_S, frames, 1.5);
    assertEquals(1 / 30.0, control.positionRad().get(0) - begin, 2e-3);
    assertFalse(ticket.finished());
    control.resume();
    while (!ticket.finished()) {
      control.step();
    }
    assertEquals(START.with(0, 2), control.positionRad());
  }

  @Test
  void anArmWithoutPowerGivesUpItsMotionAndRestsWhereItIs() throws PlanningException {
    MotionControl control = new MotionControl(arm, START);
    MotionTicket ticket = control.start(turnBase(2, 1));
    for (int i = 0; i < 100; i++) {
      control.step();
    }
    Joints elsewhere = START.with(0, 0.3);
    control.adopt(elsewhere);
    control.step();
    assertEquals("power-off", ticket.failure().orElseThrow().code());
    assertFalse(control.moving());
    assertEquals(elsewhere, control.positionRad());
    assertEquals(Joints.ZERO, control.speedRadPerS());
  }
}
