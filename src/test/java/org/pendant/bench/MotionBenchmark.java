package org.pendant.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.time.FrameTime;
import org.pendant.motion.MotionControl;
import org.pendant.motion.MotionTicket;
import org.pendant.motion.Move;
import org.pendant.motion.MoveLimits;
import org.pendant.motion.PlanningException;
import org.pendant.motion.Routes;

/**
 * Planning moves of a UR5e and following them, without an arm behind the target: a zigzag of 24
 * waypoints 30 mm apart, each with a blend radius of 5 mm.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 2, time = 1)
@Measurement(iterations = 4, time = 1)
public class MotionBenchmark {
  private static final int WAYPOINTS = 24;
  private static final Joints READY =
      new Joints(0, -Math.PI / 2, -Math.PI / 2, -Math.PI / 2, Math.PI / 2, 0);
  private static final Pose TCP = new Pose(0, 0, 0.1, 0, 0, 0);

  @Param({"movej", "movel"})
  String kind;

  @Param({"1", "2"})
  int version;

  private final ArmDescription arm = ArmLibrary.load("ur5e");
  private final ForwardKinematics forward = new ForwardKinematics(arm);
  private final List<Move> moves = new ArrayList<>();
  private final MotionControl control = new MotionControl(arm, READY);
  private MotionTicket ticket;
  private int next;

  /** Makes the moves and starts the first. */
  @Setup
  public void make() throws PlanningException {
    InverseKinematics inverse = new InverseKinematics(arm);
    Pose home = forward.tcpPose(READY, TCP);
    Joints near = READY;
    for (int i = 0; i < WAYPOINTS; i++) {
      double y = 0.03 * (i < WAYPOINTS / 2 ? i + 1 : WAYPOINTS - i - 1);
      Pose goal = Poses.add(home, new Pose(i % 2 * 0.01, y, 0, 0, 0, 0));
      near = inverse.closest(InverseKinematics.flangeOf(goal, TCP), near).orElseThrow();
      moves.add(move(goal, near));
    }
    go();
  }

  private Move move(Pose goal, Joints q) {
    double jerkRampS = version == 2 ? 0.08 : 0;
    return kind.equals("movej")
        ? new Move(
            from -> Routes.joints(arm, from, q, goal, TCP),
            new MoveLimits(1.4, 1.05, 0),
            0.005,
            jerkRampS)
        : new Move(
            from -> Routes.line(arm, from, forward.tcpPose(from, TCP), goal, TCP),
            new MoveLimits(1.2, 0.25, 0),
            0.005,
            jerkRampS);
  }

  private void go() throws PlanningException {
    ticket = control.start(moves.get(next)).orElseThrow();
    ticket.outlook(moves.subList(next + 1, moves.size()));
    next = (next + 1) % WAYPOINTS;
  }

  /** Plans a move from rest of which nothing is known that follows. */
  @Benchmark
  public MotionTicket plan() throws PlanningException {
    control.adopt(READY);
    return control.start(moves.getFirst()).orElseThrow();
  }

  /** Plans a move from rest, and again when 23 more are known. */
  @Benchmark
  public MotionTicket planWithOutlook() throws PlanningException {
    control.adopt(READY);
    MotionTicket planned = control.start(moves.getFirst()).orElseThrow();
    planned.outlook(moves.subList(1, moves.size()));
    return planned;
  }

  /** A frame of a chain; one in about sixty plans a blended move with an outlook. */
  @Benchmark
  public double frame() throws PlanningException {
    control.step();
    if (ticket.finished()) {
      go();
    } else if (ticket.failure().isPresent()) {
      throw new IllegalStateException(ticket.failure().get().message());
    }
    return FrameTime.FRAME_S * control.scaling();
  }
}
