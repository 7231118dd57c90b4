package org.pendant.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.time.FrameTime;

@Tag("slow")
final class BlendTest {
  private static final double FRAME_S = FrameTime.FRAME_S;
  private static final Joints READY =
      new Joints(0, -Math.PI / 2, -Math.PI / 2, -Math.PI / 2, Math.PI / 2, 0);
  private static final Pose TCP = new Pose(0, 0, 0.1, 0, 0, 0);

  private final ArmDescription arm = ArmLibrary.load("ur5e");
  private final ForwardKinematics forward = new ForwardKinematics(arm);
  private final InverseKinematics inverse = new InverseKinematics(arm);
  private final Pose home = forward.tcpPose(READY, TCP);

  private Move movel(Pose goal, double a, double v, double r, double ramp) {
    return new Move(
        from -> Routes.line(arm, from, forward.tcpPose(from, TCP), goal, TCP),
        new MoveLimits(a, v, 0),
        r,
        ramp);
  }

  private Move movej(Joints goal, double a, double v, double r, double ramp) {
    return new Move(
        from -> Routes.joints(arm, from, goal, forward.tcpPose(goal, TCP), TCP),
        new MoveLimits(a, v, 0),
        r,
        ramp);
  }

  private Pose shifted(double x, double y, double z) {
    return new Pose(home.x() + x, home.y() + y, home.z() + z, home.rx(), home.ry(), home.rz());
  }

  /** Positions and speeds, frame by frame, and the frames in which the moves were handed over. */
  private static final class Trace {
    final List<Joints> q = new ArrayList<>();
    final List<Joints> qd = new ArrayList<>();
    final List<Integer> handed = new ArrayList<>();
  }

  private Trace run(List<Move> moves) throws PlanningException {
    MotionControl control = new MotionControl(arm, READY);
    Trace trace = new Trace();
    trace.q.add(READY);
    trace.qd.add(Joints.ZERO);
    for (Move move : moves) {
      Optional<MotionTicket> ticket = control.start(move);
      while (ticket.isPresent() && !ticket.get().finished()) {
        control.step();
        assertTrue(ticket.get().failure().isEmpty(), () -> ticket.get().failure().toString());
        trace.q.add(control.positionRad());
        trace.qd.add(control.speedRadPerS());
        assertTrue(trace.q.size() < 100_000);
      }
      trace.handed.add(trace.q.size() - 1);
    }
    while (control.moving()) {
      control.step();
      trace.q.add(control.positionRad());
      trace.qd.add(control.speedRadPerS());
    }
    return trace;
  }

  private double distance(Joints q, Pose point) {
    return Poses.pointDistance(forward.tcpPose(q, TCP), point);
  }

  @Test
  void cutsACornerInsideItsSphereWithoutStopping() throws PlanningException {
    Pose corner = shifted(0.2, 0, 0);
    Trace trace =
        run(
            List.of(
                movel(corner, 1.2, 0.25, 0.05, 0), movel(shifted(0.2, 0.2, 0), 1.2, 0.25, 0, 0)));
    double nearest = trace.q.stream().mapToDouble(q -> distance(q, corner)).min().orElseThrow();
    // the parabola between the ends of both legs of r passes at r / 2 * sin(45 degrees)
    assertEquals(0.025 * Math.sqrt(0.5), nearest, 1e-3);
    double slowest = Double.POSITIVE_INFINITY;
    for (int k = 120; k < trace.q.size() - 120; k++) {
      Pose now = forward.tcpPose(trace.q.get(k), TCP);
      Pose next = forward.tcpPose(trace.q.get(k + 1), TCP);
      slowest = Math.min(slowest, Poses.pointDistance(now, next) / FRAME_S);
      if (distance(trace.q.get(k), corner) > 0.0501) {
        double beside = Math.min(Math.abs(now.y() - home.y()), Math.abs(now.x() - home.x() - 0.2));
        assertTrue(beside < 1e-6, "frame " + k + " is " + beside + " m beside the path");
      }
    }
    assertTrue(slowest > 0.15, "slowest " + slowest);
  }

  @Test
  void continuesWhereTheSphereBegins() throws PlanningException {
    Pose corner = shifted(0.2, 0, 0);
    Trace trace =
        run(
            List.of(
                movel(corner, 1.2, 0.25, 0.05, 0), movel(shifted(0.2, 0.2, 0), 1.2, 0.25, 0, 0)));
    assertEquals(0.05, distance(trace.q.get(trace.handed.getFirst()), corner), 0.25 * FRAME_S);
  }

  @Test
  void goesStraightOnAtFullSpeedThroughAWaypointOnTheLine() throws PlanningException {
    Trace blended =
        run(
            List.of(
                movel(shifted(0.15, 0, 0), 1.2, 0.25, 0.06, 0),
                movel(shifted(0.3, 0, 0), 1.2, 0.25, 0, 0)));
    Trace whole = run(List.of(movel(shifted(0.3, 0, 0), 1.2, 0.25, 0, 0)));
    assertEquals(whole.q.size(), blended.q.size(), 2);
  }

  @Test
  void comesToRestInTheWaypointWhenNoMoveFollows() throws PlanningException {
    Pose corner = shifted(0.2, 0, 0);
    Trace trace = run(List.of(movel(corner, 1.2, 0.25, 0.05, 0)));
    assertEquals(0, distance(trace.q.getLast(), corner), 1e-9);
    assertEquals(Joints.ZERO, trace.qd.getLast());
    assertTrue(trace.handed.getFirst() < trace.q.size() - 10);
  }

  @Test
  void leavesOutAMoveWhoseBlendReachesIntoTheOneBefore() throws PlanningException {
    Trace trace =
        run(
            List.of(
                movel(shifted(0.2, 0, 0), 1.2, 0.25, 0.06, 0),
                movel(shifted(0.2, 0.1, 0), 1.2, 0.25, 0.06, 0),
                movel(shifted(0.2, 0.2, 0.1), 1.2, 0.25, 0, 0)));
    assertEquals(trace.handed.get(0), trace.handed.get(1));
    double nearest =
        trace.q.stream().mapToDouble(q -> distance(q, shifted(0.2, 0.1, 0))).min().orElseThrow();
    assertTrue(nearest > 0.03, "passes at " + nearest);
    assertEquals(0, distance(trace.q.getLast(), shifted(0.2, 0.2, 0.1)), 1e-9);
  }

  @Test
  void makesBothSpheresSmallerWhereTheyOverlapInVersion2() throws PlanningException {
    Trace trace =
        run(
            List.of(
                movel(shifted(0.2, 0, 0), 1.2, 0.25, 0.06, 0.08),
                movel(shifted(0.2, 0.1, 0), 1.2, 0.25, 0.06, 0.08),
                movel(shifted(0.2, 0.2, 0.1), 1.2, 0.25, 0, 0.08)));
    double nearest =
        trace.q.stream().mapToDouble(q -> distance(q, shifted(0.2, 0.1, 0))).min().orElseThrow();
    assertTrue(nearest < 0.03, "passes at " + nearest);
  }

  @Test
  void randomChainsNeverJumpAndKeepToTheirPaths() throws PlanningException {
    for (long seed = 0; seed < 100 * Integer.getInteger("test.cases", 1); seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      double ramp = random.nextBoolean() ? 0 : 0.08;
      List<Move> moves = new ArrayList<>();
      Joints at = READY;
      for (int i = 0; i < 10; i++) {
        double r = i == 9 ? 0 : random.nextDouble(0.001, 0.05);
        Pose goal =
            shifted(
                random.nextDouble(-0.15, 0.15),
                random.nextDouble(-0.15, 0.15),
                random.nextDouble(-0.15, 0.15));
        Joints q = inverse.closest(InverseKinematics.flangeOf(goal, TCP), at).orElseThrow();
        Move move =
            random.nextBoolean()
                ? movel(goal, random.nextDouble(0.3, 3), random.nextDouble(0.05, 0.6), r, ramp)
                : movej(q, random.nextDouble(0.5, 6), random.nextDouble(0.2, 2), r, ramp);
        at = q;
        moves.add(move);
      }
      String input = "seed " + seed + ", ramp " + ramp;
      Trace trace = run(moves);
      assertEquals(0, trace.q.getLast().maxAbsDifference(at), 1e-9, input);
      double worst = 0;
      for (int k = 1; k < trace.q.size(); k++) {
        for (int i = 0; i < Joints.COUNT; i++) {
          double moved = trace.q.get(k).get(i) - trace.q.get(k - 1).get(i);
          double before = trace.qd.get(k - 1).get(i);
          double now = trace.qd.get(k).get(i);
          String where = input + ", frame " + k + ", joint " + i;
          worst = Math.max(worst, Math.abs(now - before) / FRAME_S);
          assertEquals((before + now) / 2 * FRAME_S, moved, 60 * FRAME_S * FRAME_S, where);
          assertTrue(Math.abs(now - before) <= 60 * FRAME_S, where + ": " + (now - before));
          assertTrue(Math.abs(now) <= Math.PI * (1 + 1e-9), where);
        }
      }
    }
  }
}
