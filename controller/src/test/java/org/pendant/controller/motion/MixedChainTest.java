package org.pendant.controller.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.controller.value.ScriptError;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/** Random chains of every kind of move, blended as it comes. */
final class MixedChainTest {
  private static final int CHAINS = 100;

  /** Changes of speed within a frame; a corner that comes unexpected takes the most. */
  private static final double MOST_RAD_PER_S2 = 150;

  private final MoveChain chain = new MoveChain();
  private final InverseKinematics inverse = new InverseKinematics(chain.arm);

  /** A move with a blend radius and the same one without, and where both lead. */
  private record Leg(Move blended, Move stopping, Joints goal) {}

  private Leg leg(SplittableRandom random, int[] kinds, Joints from, double r, double ramp) {
    Pose goal =
        chain.shifted(
            random.nextDouble(-0.12, 0.12),
            random.nextDouble(-0.12, 0.12),
            random.nextDouble(-0.12, 0.12));
    Pose turned =
        Poses.trans(
            goal, new Pose(0, 0, 0, random.nextDouble(-0.3, 0.3), random.nextDouble(-0.3, 0.3), 0));
    Joints q =
        inverse.closest(InverseKinematics.flangeOf(turned, MoveChain.TCP), from).orElseThrow();
    double a = random.nextDouble(0.3, 3);
    double v = random.nextDouble(0.05, 0.5);
    double share = random.nextDouble(0.05, 0.6);
    Pose via = between(chain.tcp(from), goal, random);
    int kind = kinds[random.nextInt(kinds.length)];
    return new Leg(
        move(kind, q, turned, via, a, v, share, r, ramp),
        move(kind, q, turned, via, a, v, share, 0, ramp),
        q);
  }

  private static Pose between(Pose from, Pose to, SplittableRandom random) {
    Pose middle = Poses.interpolate(from, to, 0.5);
    double aside = random.nextDouble(0.05, 0.2) * Poses.pointDistance(from, to);
    return new Pose(middle.x() + aside, middle.y() - aside, middle.z() + aside, 0, 0, 0);
  }

  private Move move(
      int kind,
      Joints q,
      Pose goal,
      Pose via,
      double a,
      double v,
      double share,
      double r,
      double ramp) {
    return switch (kind) {
      case 0 -> chain.movej(q, 2 * a, 3 * v, r, ramp);
      case 1 -> chain.movel(goal, a, v, r, ramp);
      case 2 -> chain.movep(goal, a, v, r);
      case 3 -> chain.movec(via, goal, a, v, r, false);
      case 4 -> chain.optimovej(q, share, share, r);
      case 5 -> chain.optimovel(goal, share, share, r);
      default -> throw new IllegalArgumentException("kind is " + kind);
    };
  }

  /** A chain of moves of some kinds, run with and without blends; it must be smooth and exact. */
  private double secondsGained(long seed, int... kinds) throws ScriptError {
    SplittableRandom random = new SplittableRandom(seed);
    double ramp = random.nextBoolean() ? 0 : 0.08;
    List<Move> blended = new ArrayList<>();
    List<Move> stopping = new ArrayList<>();
    Joints at = MoveChain.READY;
    for (int i = 0; i < 10; i++) {
      double r = i == 9 ? 0 : random.nextDouble(0.001, 0.05);
      Leg leg = leg(random, kinds, at, r, ramp);
      at = leg.goal();
      blended.add(leg.blended());
      stopping.add(leg.stopping());
    }
    String input = "seed " + seed + ", ramp " + ramp;
    MoveChain.Trace quick = chain.run(blended);
    chain.assertSmooth(quick, MOST_RAD_PER_S2, input);
    assertEquals(0, quick.q().getLast().maxAbsDifference(at), 1e-9, input);
    assertEquals(Joints.ZERO, quick.qd().getLast(), input);
    MoveChain.Trace slow = chain.run(stopping);
    chain.assertSmooth(slow, MOST_RAD_PER_S2, input);
    assertEquals(0, slow.q().getLast().maxAbsDifference(at), 1e-9, input);
    return slow.durationS() - quick.durationS();
  }

  @Test
  void chainsOfEveryKindNeverJumpAndEndExactly() throws ScriptError {
    for (long seed = 0; seed < CHAINS; seed++) {
      secondsGained(seed, 0, 1, 2, 3, 4, 5);
    }
  }

  @Test
  void processMovesGainTimeByBlending() throws ScriptError {
    List<Long> slower = new ArrayList<>();
    for (long seed = 0; seed < CHAINS; seed++) {
      if (secondsGained(seed, 2, 3) <= 0) {
        slower.add(seed);
      }
    }
    // an even speed may cost more than a stop where one corner follows right after another
    assertTrue(slower.size() <= CHAINS / 50, "slower: seeds " + slower);
  }
}
