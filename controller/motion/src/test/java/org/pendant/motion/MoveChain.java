package org.pendant.motion;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.models.time.FrameTime;

/** Chains of moves of a ur5e, run as a program would that says its next moves in time. */
final class MoveChain {
  static final Joints READY =
      new Joints(0, -Math.PI / 2, -Math.PI / 2, -Math.PI / 2, Math.PI / 2, 0);
  static final Pose TCP = new Pose(0, 0, 0.1, 0, 0, 0);

  private static final int MAX_FRAMES = 100_000;

  /** Share of the joint speeds that are used; the speed may grow within a frame. */
  private static final double SPEED_SHARE = 0.99;

  final ArmDescription arm = ArmLibrary.load("ur5e");
  final TorquePathLimits headroom = new TorquePathLimits(arm);
  private final ForwardKinematics forward = new ForwardKinematics(arm);
  private final Jacobian jacobian = new Jacobian(arm);
  private final double[] matrix = new double[Jacobian.SIZE];
  private final double[] twist = new double[Pose.SIZE];
  private final Pose home = forward.tcpPose(READY, TCP);

  /** Joint positions and speeds, frame by frame. */
  record Trace(List<Joints> q, List<Joints> qd) {
    double durationS() {
      return (q.size() - 1) * FrameTime.FRAME_S;
    }
  }

  Pose tcp(Joints q) {
    return forward.tcpPose(q, TCP);
  }

  /** How fast the tool moves and turns, in the base frame. */
  Pose twist(Joints q, Joints qd) {
    jacobian.at(q.toArray(), TCP, matrix);
    Jacobian.twist(matrix, qd.toArray(), twist);
    return Pose.of(twist);
  }

  /** The first pose, moved along the axes of the base. */
  Pose shifted(double x, double y, double z) {
    return new Pose(home.x() + x, home.y() + y, home.z() + z, home.rx(), home.ry(), home.rz());
  }

  Move movel(Pose goal, double a, double v, double r, double ramp) {
    return new Move(
        from -> Routes.line(arm, from, tcp(from), goal, TCP), new MoveLimits(a, v, 0), r, ramp);
  }

  Move movej(Joints goal, double a, double v, double r, double ramp) {
    return new Move(
        from -> Routes.joints(arm, from, goal, tcp(goal), TCP), new MoveLimits(a, v, 0), r, ramp);
  }

  Move movep(Pose goal, double a, double v, double r) {
    return new Move(
        from ->
            Routes.line(arm, from, tcp(from), goal, TCP, headroom.asAsked(new MoveLimits(a, v, 0))),
        new MoveLimits(a, v, 0),
        r,
        0,
        Move.Kind.PROCESS);
  }

  Move movec(Pose via, Pose goal, double a, double v, double r, boolean fixed) {
    ArcRoute route =
        new ArcRoute(arm, via, goal, fixed, TCP, headroom.asAsked(new MoveLimits(a, v, 0)));
    return new Move(
        from -> route.from(from, tcp(from)), new MoveLimits(a, v, 0), r, 0, Move.Kind.PROCESS);
  }

  Move optimovej(Joints goal, double a, double v, double r) {
    PathLimits share = headroom.share(v, a, Double.POSITIVE_INFINITY);
    return new Move(
        from -> Routes.joints(arm, from, goal, tcp(goal), TCP, share),
        new MoveLimits(1e9, 1e9, 0),
        r,
        0.08);
  }

  Move optimovel(Pose goal, double a, double v, double r) {
    PathLimits share = headroom.share(v, a, Double.POSITIVE_INFINITY);
    return new Move(
        from -> Routes.line(arm, from, tcp(from), goal, TCP, share),
        new MoveLimits(1e9, 1e9, 0),
        r,
        0.08);
  }

  Trace run(List<Move> moves) throws PlanningException {
    return run(moves, new ArrayList<>());
  }

  /**
   * Runs a chain.
   *
   * @param handed takes the frame at which each move was over for the program
   */
  Trace run(List<Move> moves, List<Integer> handed) throws PlanningException {
    MotionControl control = new MotionControl(arm, READY, this::largestScaling);
    Trace trace = new Trace(new ArrayList<>(List.of(READY)), new ArrayList<>(List.of(Joints.ZERO)));
    for (int i = 0; i < moves.size(); i++) {
      Optional<MotionTicket> started = control.start(moves.get(i));
      if (started.isPresent()) {
        MotionTicket ticket = started.get();
        if (ticket.wantsOutlook()) {
          ticket.outlook(moves.subList(i + 1, moves.size()));
        }
        while (!ticket.finished()) {
          step(control, trace);
          assertTrue(ticket.failure().isEmpty(), () -> ticket.failure().toString());
        }
      }
      handed.add(trace.q().size() - 1);
    }
    while (control.moving()) {
      step(control, trace);
    }
    return trace;
  }

  /** No joint turns faster than it can. */
  private double largestScaling(double[] q, double[] qd) {
    double largest = Double.POSITIVE_INFINITY;
    for (int i = 0; i < Joints.COUNT; i++) {
      double most = SPEED_SHARE * arm.joints().get(i).maxSpeedRadPerS();
      largest = Math.min(largest, most / Math.abs(qd[i]));
    }
    return largest;
  }

  private static void step(MotionControl control, Trace trace) {
    control.step();
    trace.q().add(control.positionRad());
    trace.qd().add(control.speedRadPerS());
    assertTrue(trace.q().size() < MAX_FRAMES);
  }

  /** Positions follow from speeds, speeds do not jump, and no joint is too fast. */
  void assertSmooth(Trace trace, double mostRadPerS2, String input) {
    double frameS = FrameTime.FRAME_S;
    for (int k = 1; k < trace.q().size(); k++) {
      for (int i = 0; i < Joints.COUNT; i++) {
        double moved = trace.q().get(k).get(i) - trace.q().get(k - 1).get(i);
        double before = trace.qd().get(k - 1).get(i);
        double now = trace.qd().get(k).get(i);
        double limit = arm.joints().get(i).maxSpeedRadPerS();
        double mean = (before + now) / 2 * frameS;
        int frame = k;
        int joint = i;
        assertTrue(
            Math.abs(now - before) <= mostRadPerS2 * frameS
                && Math.abs(mean - moved) <= mostRadPerS2 * frameS * frameS
                && Math.abs(now) <= limit * (1 + 1e-9),
            () -> input + ", frame " + frame + ", joint " + joint + ": " + before + " to " + now);
      }
    }
  }
}
