package org.pendant.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.time.FrameTime;

/**
 * Chains of ten blended moves keep to the accelerations that the moves themselves may use: those of
 * the leading axis between joint moves, those of the tool between lines. {@code -Dtest.cases=5} or
 * more for a thorough run.
 */
@Tag("slow")
final class BlendLimitsTest {
  private static final double FRAME_S = FrameTime.FRAME_S;
  private static final int MOVES = 10;
  private static final int THOROUGH = Integer.getInteger("test.cases", 1);
  private static final double RAMP_S = 0.08;
  private static final Joints READY =
      new Joints(0, -Math.PI / 2, -Math.PI / 2, -Math.PI / 2, Math.PI / 2, 0);
  private static final Pose TCP = new Pose(0, 0, 0.1, 0, 0, 0);

  /** Differences of speeds in the tool, whose direction turns meanwhile, are not exact. */
  private static final double ROUNDING = 1.01;

  private final ArmDescription arm = ArmLibrary.load("ur5e");
  private final ForwardKinematics forward = new ForwardKinematics(arm);
  private final InverseKinematics inverse = new InverseKinematics(arm);
  private final Jacobian jacobian = new Jacobian(arm);
  private final Pose home = forward.tcpPose(READY, TCP);

  /** Moves of one kind in a chain, the joint positions in which it ends, and how to name it. */
  private record Chain(boolean linear, List<Move> moves, Joints end, String name) {}

  private Chain chain(long seed, boolean linear, double jerkRampS) {
    SplittableRandom random = new SplittableRandom(seed);
    List<Move> moves = new ArrayList<>();
    Joints at = READY;
    while (moves.size() < MOVES) {
      Pose goal = goal(random);
      Optional<Joints> q = inverse.closest(InverseKinematics.flangeOf(goal, TCP), at);
      if (q.isEmpty() || q.get().maxAbsDifference(at) > 2) {
        continue;
      }
      boolean tiny = random.nextInt(5) == 0;
      double r = tiny ? random.nextDouble(1e-4, 2e-3) : random.nextDouble(1e-3, 0.08);
      double radiusM = moves.size() == MOVES - 1 ? 0 : r;
      MoveLimits limits =
          linear
              ? new MoveLimits(random.nextDouble(0.3, 3), random.nextDouble(0.02, 0.3), 0)
              : new MoveLimits(random.nextDouble(0.5, 6), random.nextDouble(0.1, 2), 0);
      at = q.get();
      moves.add(new Move(linear ? line(goal) : joints(at), limits, radiusM, jerkRampS));
    }
    return new Chain(linear, moves, at, "seed " + seed + ", ramp " + jerkRampS);
  }

  private Pose goal(SplittableRandom random) {
    double span = random.nextInt(6) == 0 ? 0.01 : 0.15;
    Pose shifted =
        new Pose(
            home.x() + random.nextDouble(-span, span),
            home.y() + random.nextDouble(-span, span),
            home.z() + random.nextDouble(-span, span),
            home.rx(),
            home.ry(),
            home.rz());
    double turn = random.nextBoolean() ? 0.4 : 1e-9;
    return Poses.trans(
        shifted,
        new Pose(
            0,
            0,
            0,
            random.nextDouble(-turn, turn),
            random.nextDouble(-turn, turn),
            random.nextDouble(-turn, turn)));
  }

  private Move.PathPlanner line(Pose goal) {
    return from -> Routes.line(arm, from, forward.tcpPose(from, TCP), goal, TCP);
  }

  private Move.PathPlanner joints(Joints goal) {
    return from -> Routes.joints(arm, from, goal, forward.tcpPose(goal, TCP), TCP);
  }

  /** Runs a chain and looks at each frame; returns how many there were. */
  private int run(Chain chain, boolean foreseen) throws PlanningException {
    MotionControl control = new MotionControl(arm, READY);
    int frames = 0;
    Move before = chain.moves.getFirst();
    for (int m = 0; m < MOVES; m++) {
      Move move = chain.moves.get(m);
      Optional<MotionTicket> ticket = control.start(move);
      if (ticket.isEmpty()) {
        continue;
      }
      if (foreseen) {
        ticket.get().outlook(chain.moves.subList(m + 1, MOVES));
      }
      double allowed = Math.max(before.limits().acceleration(), move.limits().acceleration());
      while (!ticket.get().finished()) {
        Joints q = control.positionRad();
        Joints qd = control.speedRadPerS();
        control.step();
        frames++;
        int number = m;
        int frame = frames;
        Supplier<String> where = () -> chain.name + ", move " + number + ", frame " + frame;
        assertEquals(Optional.empty(), ticket.get().failure(), where);
        checkFrame(chain, q, qd, control, allowed, where);
        assertTrue(frames < 100_000, where);
      }
      before = move;
    }
    assertEquals(0, control.positionRad().maxAbsDifference(chain.end), 1e-9, chain.name);
    assertEquals(Joints.ZERO, control.speedRadPerS(), chain.name);
    return frames;
  }

  private void checkFrame(
      Chain chain,
      Joints q,
      Joints qd,
      MotionControl control,
      double allowed,
      Supplier<String> where) {
    Joints now = control.positionRad();
    Joints speed = control.speedRadPerS();
    for (int i = 0; i < Joints.COUNT; i++) {
      double mean = 0.5 * (qd.get(i) + speed.get(i)) * FRAME_S;
      assertEquals(mean, now.get(i) - q.get(i), 4 * FRAME_S * FRAME_S, where);
      assertTrue(Math.abs(speed.get(i)) <= Math.PI * (1 + 1e-9), where);
    }
    double used =
        chain.linear ? toolAcceleration(q, qd, now, speed) : speed.maxAbsDifference(qd) / FRAME_S;
    assertTrue(used <= allowed * ROUNDING, () -> where.get() + ": " + used + " of " + allowed);
  }

  /** Change of the tool's speed, m/s²; turning counts as on a path. */
  private double toolAcceleration(Joints q, Joints qd, Joints now, Joints speed) {
    Pose from = twist(q, qd);
    Pose to = twist(now, speed);
    double linear =
        Math.sqrt(
            square(to.x() - from.x()) + square(to.y() - from.y()) + square(to.z() - from.z()));
    double turning =
        Math.sqrt(
            square(to.rx() - from.rx())
                + square(to.ry() - from.ry())
                + square(to.rz() - from.rz()));
    return Math.max(linear, turning / MoveL.ROTATION_FACTOR) / FRAME_S;
  }

  private Pose twist(Joints q, Joints qd) {
    double[] matrix = new double[Jacobian.SIZE];
    double[] twist = new double[Pose.SIZE];
    jacobian.at(q.toArray(), TCP, matrix);
    Jacobian.twist(matrix, qd.toArray(), twist);
    return Pose.of(twist);
  }

  private static double square(double x) {
    return x * x;
  }

  @ParameterizedTest
  @CsvSource({"false, 0", "false, 0.08", "true, 0", "true, 0.08"})
  void chainsNeedNoMoreAccelerationThanTheirMoves(boolean linear, double jerkRampS)
      throws PlanningException {
    for (long seed = 0; seed < 25L * THOROUGH; seed++) {
      Chain chain = chain(seed, linear, jerkRampS);
      run(chain, false);
      run(chain, true);
    }
  }

  @Test
  void knowingWhatComesNeverMakesAChainMuchSlower() throws PlanningException {
    for (long seed = 500; seed < 500 + 20L * THOROUGH; seed++) {
      Chain chain = chain(seed, seed % 2 == 0, seed % 4 < 2 ? 0 : 0.08);
      int blind = run(chain, false);
      int foreseen = run(chain, true);
      assertTrue(foreseen <= blind * 1.02 + 5, chain.name + ": " + foreseen + " after " + blind);
    }
  }

  @Test
  void noJointJerksMoreInAVersion2BlendThanBothMovesTogetherMay() throws PlanningException {
    SplittableRandom random = new SplittableRandom(5);
    for (int each = 0; each < 40 * THOROUGH; each++) {
      Chain chain = chain(1000 + each, false, RAMP_S);
      Move first = chain.moves.get(0);
      Move second = chain.moves.get(1);
      List<Move> outlook = random.nextBoolean() ? List.of(second) : List.of();
      PathMotion leaving = MovePlanner.fromRest(first, READY, outlook);
      Motion joined =
          MovePlanner.blended(leaving, leaving.handOverS(), second, List.of()).orElseThrow();
      double one = first.limits().acceleration() / RAMP_S;
      double other = second.limits().acceleration() / RAMP_S;
      double jerk = one + other;
      double step = joined.durationS() / 5000;
      Joints before = accelerationAt(joined, step);
      for (double t = 2 * step; t < joined.durationS(); t += step) {
        Joints now = accelerationAt(joined, t);
        double change = now.maxAbsDifference(before);
        double timeS = t;
        assertTrue(
            change <= jerk * step * ROUNDING + 1e-9,
            () -> chain.name + " at " + timeS + ": " + change / step + " of " + jerk);
        before = now;
      }
    }
  }

  @Test
  void theToolJerksNoMoreInAVersion2BlendThanTheStrongerLineMay() throws PlanningException {
    double step = 2e-3;
    for (int each = 0; each < 40 * THOROUGH; each++) {
      Chain chain = chain(3000 + each, true, RAMP_S);
      Move first = chain.moves.get(0);
      Move second = chain.moves.get(1);
      PathMotion leaving = MovePlanner.fromRest(first, READY, List.of(second));
      Motion joined =
          MovePlanner.blended(leaving, leaving.handOverS(), second, List.of()).orElseThrow();
      double jerk =
          Math.max(first.limits().acceleration(), second.limits().acceleration()) / RAMP_S;
      Pose before = twistAt(joined, 0);
      Pose now = twistAt(joined, step);
      for (double t = 2 * step; t < joined.durationS(); t += step) {
        Pose next = twistAt(joined, t);
        double change =
            Math.hypot(
                Math.hypot(
                    next.x() - 2 * now.x() + before.x(), next.y() - 2 * now.y() + before.y()),
                next.z() - 2 * now.z() + before.z());
        double timeS = t;
        assertTrue(
            change <= jerk * step * step * ROUNDING + 1e-7,
            () -> chain.name + " at " + timeS + ": " + change / step / step + " of " + jerk);
        before = now;
        now = next;
      }
    }
  }

  private Pose twistAt(Motion motion, double timeS) {
    MotionSample sample = new MotionSample();
    assertEquals(Optional.empty(), motion.sample(timeS, sample));
    return twist(sample.positionRad(), sample.speedRadPerS());
  }

  private static Joints accelerationAt(Motion motion, double timeS) {
    MotionSample sample = new MotionSample();
    assertEquals(Optional.empty(), motion.sample(timeS, sample));
    return sample.accelerationRadPerS2();
  }
}
