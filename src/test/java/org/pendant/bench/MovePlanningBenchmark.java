package org.pendant.bench;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.motion.ArcRoute;
import org.pendant.motion.MotionControl;
import org.pendant.motion.MotionTicket;
import org.pendant.motion.Move;
import org.pendant.motion.MoveLimits;
import org.pendant.motion.PathLimits;
import org.pendant.motion.PlanningException;
import org.pendant.motion.Routes;
import org.pendant.motion.TorquePathLimits;

/**
 * Planning moves of the UR5e: circles, process moves, and those that look at what the arm can do on
 * their way; and frames of a circle.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(3)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 4, time = 1)
public class MovePlanningBenchmark {
  private static final Joints READY =
      new Joints(0, -Math.PI / 2, -Math.PI / 2, -Math.PI / 2, Math.PI / 2, 0);
  private static final Pose TCP = new Pose(0, 0, 0.1, 0, 0, 0);
  private static final MoveLimits FREE = new MoveLimits(1e9, 1e9, 0);
  private static final MoveLimits USUAL = new MoveLimits(1.2, 0.25, 0);

  private ArmDescription arm;
  private ForwardKinematics forward;
  private Move circle;
  private Move corner;
  private Move afterCorner;
  private Move optimalJoints;
  private Move optimalLine;
  private MotionControl running;

  /** Makes the moves. */
  @Setup
  public void prepare() {
    arm = ArmLibrary.load("ur5e");
    forward = new ForwardKinematics(arm);
    PathLimits all = new TorquePathLimits(arm).share(1, 1, Double.POSITIVE_INFINITY);
    Pose home = forward.tcpPose(READY, TCP);
    ArcRoute arc =
        new ArcRoute(
            arm, beside(home, 0.05, 0.05), beside(home, 0, 0.1), false, TCP, PathLimits.UNLIMITED);
    circle =
        new Move(
            from -> arc.from(from, forward.tcpPose(from, TCP)), USUAL, 0, 0, Move.Kind.PROCESS);
    corner = process(beside(home, 0.1, 0), 0.03);
    afterCorner = process(beside(home, 0.1, 0.1), 0);
    Joints goal = new Joints(1, -1, -2, -1.5, 1.2, 0.5);
    optimalJoints =
        new Move(
            from -> Routes.joints(arm, from, goal, forward.tcpPose(goal, TCP), TCP, all),
            FREE,
            0,
            0.08);
    optimalLine =
        new Move(
            from ->
                Routes.line(
                    arm, from, forward.tcpPose(from, TCP), beside(home, 0.1, 0.2), TCP, all),
            FREE,
            0,
            0.08);
    running = new MotionControl(arm, READY);
  }

  private static Pose beside(Pose home, double x, double y) {
    return new Pose(home.x() + x, home.y() + y, home.z(), home.rx(), home.ry(), home.rz());
  }

  private Move process(Pose goal, double radiusM) {
    return new Move(
        from -> Routes.line(arm, from, forward.tcpPose(from, TCP), goal, TCP),
        USUAL,
        radiusM,
        0,
        Move.Kind.PROCESS);
  }

  private Optional<MotionTicket> planned(Move move) throws PlanningException {
    return new MotionControl(arm, READY).start(move);
  }

  /** A movec. */
  @Benchmark
  public Optional<MotionTicket> circle() throws PlanningException {
    return planned(circle);
  }

  /** A movep that knows its next corner. */
  @Benchmark
  public MotionTicket processMove() throws PlanningException {
    MotionTicket ticket = planned(corner).orElseThrow();
    ticket.outlook(List.of(afterCorner));
    return ticket;
  }

  /** An optimovej. */
  @Benchmark
  public Optional<MotionTicket> optimalJoints() throws PlanningException {
    return planned(optimalJoints);
  }

  /** An optimovel. */
  @Benchmark
  public Optional<MotionTicket> optimalLine() throws PlanningException {
    return planned(optimalLine);
  }

  /** A frame of a movec; it begins anew when it is done, which counts. */
  @Benchmark
  public double frameOfCircle() throws PlanningException {
    if (!running.moving()) {
      running = new MotionControl(arm, READY);
      running.start(circle);
    }
    running.step();
    return running.scaling();
  }
}
