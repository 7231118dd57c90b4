package org.pendant.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.InverseKinematics;

/** Random chains of every kind of move, blended as it comes. */
@Tag("slow")
final class MixedChainTest {
  private static final int CHAINS = 40 * Integer.getInteger("test.cases", 1);

  /** Changes of speed within a frame; a corner that comes unexpected takes the most. */
  private static final double MAX_RAD_PER_S2 = 150;

  private final MoveChain chain = new MoveChain();
  private final InverseKinematics inverse = new InverseKinematics(chain.arm);

  /** A chain of moves of some kinds, run with and without blends; it must be smooth and exact. */
  private double secondsGained(long seed, int... kinds) throws PlanningException {
    SplittableRandom random = new SplittableRandom(seed);
    double ramp = random.nextBoolean() ? 0 : 0.08;
    List<Move> blended = new ArrayList<>();
    List<Move> stopping = new ArrayList<>();
    Joints at = MoveChain.READY;
    for (int i = 0; i < 10; i++) {
      double r = i == 9 ? 0 : random.nextDouble(0.001, 0.05);
      RandomLeg leg = RandomLeg.of(chain, inverse, random, kinds, at, r, ramp);
      at = leg.goal();
      blended.add(leg.blended());
      stopping.add(leg.stopping());
    }
    String input = "seed " + seed + ", ramp " + ramp;
    MoveChain.Trace quick = chain.run(blended);
    chain.assertSmooth(quick, MAX_RAD_PER_S2, input);
    assertEquals(0, quick.q().getLast().maxAbsDifference(at), 1e-9, input);
    assertEquals(Joints.ZERO, quick.qd().getLast(), input);
    MoveChain.Trace slow = chain.run(stopping);
    chain.assertSmooth(slow, MAX_RAD_PER_S2, input);
    assertEquals(0, slow.q().getLast().maxAbsDifference(at), 1e-9, input);
    return slow.durationS() - quick.durationS();
  }

  @Test
  void chainsOfEveryKindNeverJumpAndEndExactly() throws PlanningException {
    for (long seed = 0; seed < CHAINS; seed++) {
      secondsGained(seed, RandomLeg.KINDS);
    }
  }

  @Test
  void processMovesGainTimeByBlending() throws PlanningException {
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
