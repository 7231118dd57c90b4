package org.pendant.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.time.FrameTime;
import org.pendant.motion.profile.ProfileLimits;

@Tag("slow")
final class MotionControlTest {
  private static final double FRAME_S = FrameTime.FRAME_S;
  private static final Joints READY =
      new Joints(0, -Math.PI / 2, -Math.PI / 2, -Math.PI / 2, Math.PI / 2, 0);
  private static final Pose TCP = new Pose(0.01, -0.02, 0.12, 0.1, -0.3, 0.2);
  private static final int CASES = 200;

  private final ArmDescription arm = ArmLibrary.load("ur5e");
  private final ForwardKinematics forward = new ForwardKinematics(arm);
  private final SplittableRandom random = new SplittableRandom(2);

  /** What a motion did, frame by frame; the first entry is the rest before it. */
  private record Trace(List<Joints> q, List<Joints> qd, List<Joints> qdd) {
    static Trace of(MotionControl control) {
      Trace trace = new Trace(new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
      trace.note(control);
      return trace;
    }

    void note(MotionControl control) {
      q.add(control.positionRad());
      qd.add(control.speedRadPerS());
      qdd.add(control.accelerationRadPerS2());
    }

    int frames() {
      return q.size() - 1;
    }
  }

  private double between(double low, double high) {
    return low + (high - low) * random.nextDouble();
  }

  private Joints near(Joints middle, double spread) {
    double[] q = new double[Joints.COUNT];
    for (int i = 0; i < q.length; i++) {
      q[i] = middle.get(i) + between(-spread, spread);
    }
    return Joints.of(q);
  }

  private MotionPlan movej(Joints goal, MoveLimits limits) {
    return (from, speed) -> new MoveJ(arm, from, goal, forward.tcpPose(goal, TCP), limits);
  }

  private MotionPlan movel(Pose goal, MoveLimits limits) {
    return (from, speed) -> new MoveL(arm, from, forward.tcpPose(from, TCP), goal, TCP, limits);
  }

  private static Trace finish(MotionControl control, MotionTicket ticket) {
    Trace trace = Trace.of(control);
    while (!ticket.finished()) {
      control.step();
      trace.note(control);
      assertTrue(ticket.failure().isEmpty(), () -> ticket.failure().toString());
      assertTrue(trace.frames() < 100_000);
    }
    return trace;
  }

  private void assertConsistent(Trace trace, double acceleration, String input) {
    for (int k = 1; k <= trace.frames(); k++) {
      for (int i = 0; i < Joints.COUNT; i++) {
        double moved = trace.q.get(k).get(i) - trace.q.get(k - 1).get(i);
        double before = trace.qd.get(k - 1).get(i);
        double now = trace.qd.get(k).get(i);
        double limit = arm.joints().get(i).maxSpeedRadPerS();
        assertTrue(Math.abs(moved) <= limit * FRAME_S * (1 + 1e-9), input);
        assertTrue(Math.abs(now - before) <= acceleration * FRAME_S * (1 + 1e-6) + 1e-12, input);
        double mean = (before + now) / 2;
        assertEquals(mean * FRAME_S, moved, acceleration * FRAME_S * FRAME_S, input);
      }
    }
  }

  @Test
  void whatIsGivenOutStaysAsItWasInItsFrame() throws PlanningException {
    MotionControl control = new MotionControl(arm, READY);
    control.start(movej(near(READY, 0.5), new MoveLimits(1, 1, 0)));
    for (int i = 0; i < 100; i++) {
      control.step();
    }
    Joints q = control.positionRad();
    Joints qd = control.speedRadPerS();
    Joints qdd = control.accelerationRadPerS2();
    double[] then = q.toArray();
    assertSame(q, control.positionRad());
    control.step();
    assertEquals(Joints.of(then), q);
    assertNotEquals(q, control.positionRad());
    assertNotEquals(qd, control.speedRadPerS());
    assertEquals(0, qdd.maxAbsDifference(control.accelerationRadPerS2()), 1e-9);
  }

  @Test
  void movejKeepsItsLimitsMeetsItsGoalAndTakesTheTimeOfItsProfile() throws PlanningException {
    for (int each = 0; each < CASES; each++) {
      Joints start = near(READY, 2);
      Joints goal = near(READY, 2);
      MoveLimits limits = new MoveLimits(between(0.1, 15), between(0.05, 6), 0);
      String input = start + " to " + goal + " with " + limits;
      MotionControl control = new MotionControl(arm, start);
      Trace trace = finish(control, control.start(movej(goal, limits)));

      double distance = goal.maxAbsDifference(start);
      double speed = Math.min(limits.speed(), arm.joints().getFirst().maxSpeedRadPerS());
      double duration = ProfileLimits.of(speed, limits.acceleration()).over(distance).durationS();
      assertEquals(Math.ceil(duration / FRAME_S - 1e-9), trace.frames(), input);
      assertEquals(goal, control.positionRad(), input);
      assertEquals(Joints.ZERO, control.speedRadPerS(), input);
      assertConsistent(trace, limits.acceleration(), input);
      for (Joints q : trace.q) {
        assertProportional(start, goal, q, input);
      }
    }
  }

  private static void assertProportional(Joints start, Joints goal, Joints q, String input) {
    double whole = goal.maxAbsDifference(start);
    double part = q.maxAbsDifference(start);
    for (int i = 0; i < Joints.COUNT; i++) {
      double expected = start.get(i) + (goal.get(i) - start.get(i)) * part / whole;
      assertEquals(expected, q.get(i), 1e-12, input);
    }
  }

  @Test
  void movelStaysOnTheLineAndMeetsItsGoal() throws PlanningException {
    for (int each = 0; each < CASES; each++) {
      Joints start = near(READY, 0.3);
      Pose from = forward.tcpPose(start, TCP);
      Pose goal = forward.tcpPose(near(start, 0.3), TCP);
      MoveLimits limits = new MoveLimits(between(0.1, 1), between(0.02, 0.2), 0);
      String input = start + " to " + goal + " with " + limits;
      MotionControl control = new MotionControl(arm, start);
      Trace trace = finish(control, control.start(movel(goal, limits)));

      double length = Poses.pointDistance(from, goal);
      double along =
          ProfileLimits.of(limits.speed(), limits.acceleration()).over(length).durationS();
      double around =
          ProfileLimits.of(
                  MoveL.ROTATION_FACTOR * limits.speed(),
                  MoveL.ROTATION_FACTOR * limits.acceleration())
              .over(Poses.rotationAngle(from, goal))
              .durationS();
      assertEquals(Math.ceil(Math.max(along, around) / FRAME_S - 1e-9), trace.frames(), input);
      assertEquals(0, Poses.distance(goal, forward.tcpPose(control.positionRad(), TCP)), 1e-9);
      assertEquals(Joints.ZERO, control.speedRadPerS(), input);
      for (Joints q : trace.q) {
        assertOnLine(from, goal, forward.tcpPose(q, TCP), input);
      }
    }
  }

  private static void assertOnLine(Pose from, Pose goal, Pose pose, String input) {
    double length = Poses.pointDistance(from, goal);
    double part = length == 0 ? 0 : Poses.pointDistance(from, pose) / length;
    Pose expected = Poses.interpolate(from, goal, part);
    assertTrue(Poses.pointDistance(expected, pose) < 2e-10, input);
    assertTrue(Poses.rotationAngle(expected, pose) < 1e-7, input);
  }

  @Test
  void speedsAndAccelerationsOfMovelAreTheDerivativesOfItsPositions() throws PlanningException {
    for (int each = 0; each < 20; each++) {
      Joints start = near(READY, 0.3);
      Pose goal = forward.tcpPose(near(start, 0.3), TCP);
      MoveL move =
          new MoveL(
              arm, start, forward.tcpPose(start, TCP), goal, TCP, new MoveLimits(0.5, 0.1, 0));
      MotionSample before = new MotionSample();
      MotionSample middle = new MotionSample();
      MotionSample after = new MotionSample();
      double step = 1e-4;
      for (double t = 0.05; t < move.durationS() - 0.05; t += 0.05) {
        assertTrue(move.sample(t - step, before).isEmpty());
        assertTrue(move.sample(t, middle).isEmpty());
        assertTrue(move.sample(t + step, after).isEmpty());
        boolean withinOnePhase =
            before.accelerationRadPerS2().maxAbsDifference(after.accelerationRadPerS2()) < 0.01;
        for (int i = 0; i < Joints.COUNT && withinOnePhase; i++) {
          double slope = (after.position[i] - before.position[i]) / (2 * step);
          assertEquals(slope, middle.speed[i], 1e-6);
          double bend = (after.speed[i] - before.speed[i]) / (2 * step);
          assertEquals(bend, middle.acceleration[i], 1e-5);
        }
      }
    }
  }

  @Test
  void aPauseAnywhereChangesNeitherThePathNorTheEnd() throws PlanningException {
    for (int each = 0; each < CASES; each++) {
      Joints start = near(READY, 0.3);
      Joints end = near(start, 0.3);
      boolean linear = each % 2 == 0;
      Pose from = forward.tcpPose(start, TCP);
      Pose goal = forward.tcpPose(end, TCP);
      MotionPlan plan =
          linear
              ? movel(goal, new MoveLimits(0.5, 0.1, 0))
              : movej(end, new MoveLimits(1.4, 1.05, 0));
      MotionControl control = new MotionControl(arm, start);
      MotionTicket ticket = control.start(plan);
      Trace trace = Trace.of(control);
      int pauseAt = random.nextInt(1, 200);
      int resumeAt = pauseAt + 400;
      String input = start + " to " + goal + " paused at " + pauseAt;
      for (int k = 1; !ticket.finished(); k++) {
        if (k == pauseAt) {
          control.pause();
        }
        if (k == resumeAt) {
          assertEquals(Joints.ZERO, control.speedRadPerS(), input);
          control.resume();
        }
        control.step();
        trace.note(control);
        assertTrue(ticket.failure().isEmpty() && k < 100_000, input);
      }
      for (Joints q : trace.q) {
        if (linear) {
          assertOnLine(from, goal, forward.tcpPose(q, TCP), input);
        } else {
          assertProportional(start, end, q, input);
        }
      }
      if (!linear) {
        assertEquals(end, control.positionRad(), input);
        assertConsistent(trace, 1.4 + MotionControl.SCALING_ACCELERATION_RAD_PER_S2, input);
      }
      assertEquals(0, Poses.distance(goal, forward.tcpPose(control.positionRad(), TCP)), 1e-9);
    }
  }

  @Test
  void halfTheSpeedTakesTwiceTheTimeThroughTheSamePoints() throws PlanningException {
    Joints goal = near(READY, 1);
    MoveLimits limits = new MoveLimits(1.4, 1.05, 0);
    MotionControl full = new MotionControl(arm, READY);
    Trace fast = finish(full, full.start(movej(goal, limits)));
    MotionControl half = new MotionControl(arm, READY);
    half.setSpeedFraction(0.5);
    Trace slow = finish(half, half.start(movej(goal, limits)));
    assertEquals(2.0 * fast.frames(), slow.frames(), 1);
    for (int k = 0; k < fast.frames(); k++) {
      assertEquals(fast.q.get(k), slow.q.get(2 * k), "frame " + k);
    }
  }

  @Test
  void abortStopsOnThePathWithinThePredictedTime() throws PlanningException {
    for (int each = 0; each < CASES; each++) {
      Joints goal = near(READY, 2);
      MotionControl control = new MotionControl(arm, READY);
      MotionTicket ticket = control.start(movej(goal, new MoveLimits(3, 3, 0)));
      int abortAt = random.nextInt(1, 300);
      for (int k = 0; k < abortAt; k++) {
        control.step();
      }
      double fastest = control.speedRadPerS().maxAbsDifference(Joints.ZERO);
      control.abort();
      int frames = 0;
      while (control.moving()) {
        control.step();
        frames++;
        assertProportional(READY, goal, control.positionRad(), goal + " at " + abortAt);
      }
      double seconds = (fastest + 3 * 0.4) / MotionControl.SCALING_ACCELERATION_RAD_PER_S2;
      assertTrue(frames * FRAME_S <= seconds + 0.1, goal + " took " + frames);
      assertFalse(ticket.finished() && abortAt < 10);
    }
  }

  @Test
  void stopjTakesOverAtSpeedAndStopsAllJointsTogether() throws PlanningException {
    Joints goal = near(READY, 2);
    MotionControl control = new MotionControl(arm, READY);
    MotionTicket move = control.start(movej(goal, new MoveLimits(1.4, 1.05, 0)));
    for (int k = 0; k < 300; k++) {
      control.step();
    }
    double fastest = control.speedRadPerS().maxAbsDifference(Joints.ZERO);
    move.cancel();
    MotionTicket stop = control.takeOver((q, qd) -> new StopJ(q, qd, 2));
    Trace trace = finish(control, stop);
    assertEquals(Math.ceil(fastest / 2 / FRAME_S - 1e-9), trace.frames());
    assertEquals(Joints.ZERO, control.speedRadPerS());
    assertConsistent(trace, 2, "stopj");
  }

  @Test
  void stoplKeepsTheDirectionOfTheTool() throws PlanningException {
    Pose from = forward.tcpPose(READY, TCP);
    Pose goal = Poses.add(from, new Pose(0.1, 0.15, -0.1, 0, 0, 0.4));
    MotionControl control = new MotionControl(arm, READY);
    MotionTicket move = control.start(movel(goal, new MoveLimits(0.5, 0.2, 0)));
    for (int k = 0; k < 300; k++) {
      control.step();
    }
    move.cancel();
    MotionTicket stop = control.takeOver((q, qd) -> new StopL(arm, q, qd, TCP, 1, 4));
    Trace trace = finish(control, stop);
    assertEquals(Joints.ZERO, control.speedRadPerS());
    for (Joints q : trace.q) {
      assertOnLine(from, goal, forward.tcpPose(q, TCP), q.toString());
    }
  }

  @Test
  void aLineThroughTheShoulderAxisFailsAndTheArmComesToRestWithinItsLimits()
      throws PlanningException {
    Pose from = forward.tcpPose(READY, Pose.ZERO);
    Pose goal = new Pose(-from.x(), -from.y(), from.z(), from.rx(), from.ry(), from.rz());
    MotionControl control = new MotionControl(arm, READY);
    MotionTicket ticket =
        control.start(
            (q, qd) -> new MoveL(arm, q, from, goal, Pose.ZERO, new MoveLimits(1.2, 0.25, 0)));
    Trace trace = Trace.of(control);
    while (ticket.failure().isEmpty() || control.moving()) {
      control.step();
      trace.note(control);
      assertFalse(ticket.finished());
    }
    assertEquals(control.fault(), ticket.failure());
    assertEquals(Joints.ZERO, control.speedRadPerS());
    for (int k = 1; k <= trace.frames(); k++) {
      double moved = trace.q.get(k).maxAbsDifference(trace.q.get(k - 1));
      assertTrue(moved <= Math.PI * FRAME_S * (1 + 1e-9), "frame " + k);
    }
  }

  @Test
  void aSecondThreadCannotMoveTheArmMeanwhile() throws PlanningException {
    MotionControl control = new MotionControl(arm, READY);
    MotionPlan plan = movej(near(READY, 1), new MoveLimits(1.4, 1.05, 0));
    control.start(plan);
    control.step();
    assertEquals(
        "robot-in-use", assertThrows(PlanningException.class, () -> control.start(plan)).code());
  }

  @Test
  void aMoveThatFollowsACancelledOneBeginsAfterItsRest() throws PlanningException {
    MotionControl control = new MotionControl(arm, READY);
    MotionTicket first = control.start(movej(near(READY, 1), new MoveLimits(1.4, 1.05, 0)));
    for (int k = 0; k < 200; k++) {
      control.step();
    }
    first.cancel();
    Joints goal = near(READY, 1);
    MotionTicket second = control.start(movej(goal, new MoveLimits(1.4, 1.05, 0)));
    Trace trace = finish(control, second);
    assertEquals(goal, control.positionRad());
    assertConsistent(trace, 1.4 + MotionControl.SCALING_ACCELERATION_RAD_PER_S2, "two moves");
  }

  @Test
  void endingEarlyRestsOnThePathAndCountsAsFinished() throws PlanningException {
    Joints goal = near(READY, 2);
    MotionControl control = new MotionControl(arm, READY);
    MotionTicket ticket = control.start(movej(goal, new MoveLimits(1.4, 1.05, 0)));
    for (int k = 0; k < 200; k++) {
      control.step();
    }
    ticket.endEarly();
    finish(control, ticket);
    assertFalse(control.moving());
    assertProportional(READY, goal, control.positionRad(), goal.toString());
  }

  @Test
  void steadyMeansHalfASecondAtRest() throws PlanningException {
    MotionControl control = new MotionControl(arm, READY);
    assertTrue(control.steady());
    MotionTicket ticket = control.start(movej(near(READY, 0.1), new MoveLimits(1.4, 1.05, 0)));
    control.step();
    assertFalse(control.steady());
    finish(control, ticket);
    for (int k = 0; k < 248; k++) {
      control.step();
    }
    assertFalse(control.steady());
    control.step();
    assertTrue(control.steady());
  }
}
