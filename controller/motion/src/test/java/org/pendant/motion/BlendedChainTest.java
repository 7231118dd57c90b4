package org.pendant.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.time.FrameTime;

/**
 * Random chains of ten blended moves of every kind: none is slower than with a stop at each
 * waypoint, none jumps, and no blend needs much more than the moves that it joins. {@code
 * -Dtest.cases=5} or more for a thorough run.
 */
@Tag("slow")
final class BlendedChainTest {
  private static final int CHAINS = 50 * Integer.getInteger("test.cases", 1);
  private static final int MOVES = 10;

  /** Frames that a blend may cost more than a stop. */
  private static final int MAX_FRAMES_LOST = 2;

  /** Joint acceleration in a blend, of what the stronger of both moves needs by itself. */
  private static final double MAX_IN_JOINTS = 1.5;

  /** Moves are compared at frames, which need not meet their strongest points. */
  private static final double ROUNDING = 1.05;

  /** Changes of speed that the arm cannot follow. */
  private static final double MAX_RAD_PER_S2 = 150;

  /** Of a move behind one that motion version 1 leaves out, the one before that counts too. */
  private static final int MAX_LEFT_OUT = 2;

  /** What a random chain came to. */
  private record Run(String input, double blendedS, double stoppingS, List<String> tooHard) {
    boolean slower() {
      return blendedS > stoppingS + MOVES * MAX_FRAMES_LOST * FrameTime.FRAME_S;
    }
  }

  private static Run run(long seed) {
    try {
      SplittableRandom random = new SplittableRandom(seed);
      MoveChain chain = new MoveChain();
      InverseKinematics inverse = new InverseKinematics(chain.arm);
      double ramp = random.nextBoolean() ? 0 : 0.08;
      List<RandomLeg> legs = new ArrayList<>();
      Joints at = MoveChain.READY;
      for (int i = 0; i < MOVES; i++) {
        double r = i == MOVES - 1 ? 0 : random.nextDouble(0.001, 0.05);
        legs.add(RandomLeg.of(chain, inverse, random, RandomLeg.KINDS, at, r, ramp));
        at = legs.getLast().goal();
      }
      String input = "seed " + seed + ", ramp " + ramp;
      List<Integer> blendedAt = new ArrayList<>();
      MoveChain.Trace blended =
          chain.run(legs.stream().map(RandomLeg::blended).toList(), blendedAt);
      chain.assertSmooth(blended, MAX_RAD_PER_S2, input);
      assertEquals(0, blended.q().getLast().maxAbsDifference(at), 1e-9, input);
      assertEquals(Joints.ZERO, blended.qd().getLast(), input);
      List<Integer> stoppingAt = new ArrayList<>();
      MoveChain.Trace stopping =
          chain.run(legs.stream().map(RandomLeg::stopping).toList(), stoppingAt);
      return new Run(
          input,
          blended.durationS(),
          stopping.durationS(),
          tooHard(
              legs,
              new Frames(chain, blended, blendedAt),
              new Frames(chain, stopping, stoppingAt)));
    } catch (PlanningException | RuntimeException e) {
      throw new AssertionError("seed " + seed, e);
    }
  }

  /** What was done in each frame, and in which of them each move was over for the program. */
  private record Frames(MoveChain chain, MoveChain.Trace trace, List<Integer> handed) {
    /** The strongest joint acceleration while a move was under way, rad/s². */
    double ofJoints(int move) {
      double peak = 0;
      for (int k = begin(move) + 1; k <= handed.get(move); k++) {
        peak = Math.max(peak, trace.qd().get(k).maxAbsDifference(trace.qd().get(k - 1)));
      }
      return peak / FrameTime.FRAME_S;
    }

    private int begin(int move) {
      return move == 0 ? 0 : handed.get(move - 1);
    }

    /** The same of the tool, m/s²; turning counts as on a path. */
    double ofTool(int move) {
      double peak = 0;
      Pose before = chain.twist(trace.q().get(begin(move)), trace.qd().get(begin(move)));
      for (int k = begin(move) + 1; k <= handed.get(move); k++) {
        Pose now = chain.twist(trace.q().get(k), trace.qd().get(k));
        double turning =
            Math.hypot(
                Math.hypot(now.rx() - before.rx(), now.ry() - before.ry()), now.rz() - before.rz());
        peak = Math.max(peak, Poses.pointDistance(now, before));
        peak = Math.max(peak, turning / MoveL.ROTATION_FACTOR);
        before = now;
      }
      return peak / FrameTime.FRAME_S;
    }
  }

  /**
   * The moves that need too much, from the hand-over of the one before to their own. Which of both
   * counts depends on what blends: lines and arcs of the tool, or anything else.
   */
  private static List<String> tooHard(List<RandomLeg> legs, Frames blended, Frames stopping) {
    List<String> tooHard = new ArrayList<>();
    for (int m = 1; m < MOVES; m++) {
      int from = Math.max(0, m - MAX_LEFT_OUT);
      double most = joints(stopping, from, m) * MAX_IN_JOINTS * ROUNDING;
      double used = blended.ofJoints(m);
      boolean ofTool = legs.subList(from, m + 1).stream().allMatch(RandomLeg::ofTool);
      if (used > most && (!ofTool || blended.ofTool(m) > tool(stopping, from, m) * ROUNDING)) {
        tooHard.add("move " + m + ": " + used + " of " + most);
      }
    }
    return tooHard;
  }

  private static double joints(Frames frames, int from, int to) {
    return IntStream.rangeClosed(from, to).mapToDouble(frames::ofJoints).max().orElseThrow();
  }

  private static double tool(Frames frames, int from, int to) {
    return IntStream.rangeClosed(from, to).mapToDouble(frames::ofTool).max().orElseThrow();
  }

  @Test
  void randomChainsAreNoSlowerThanWithStopsAndNeedLittleMoreAcceleration() {
    List<Run> runs =
        LongStream.range(0, CHAINS).parallel().mapToObj(BlendedChainTest::run).toList();
    assertEquals(List.of(), runs.stream().filter(Run::slower).toList());
    assertEquals(List.of(), runs.stream().filter(run -> !run.tooHard().isEmpty()).toList());
    double blendedS = runs.stream().mapToDouble(Run::blendedS).sum();
    double stoppingS = runs.stream().mapToDouble(Run::stoppingS).sum();
    assertTrue(blendedS < 0.95 * stoppingS, blendedS + " s with blends of " + stoppingS);
  }
}
