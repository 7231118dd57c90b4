package org.pendant.motion.offset;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.models.time.FrameTime;

final class FollowerTest {
  private static final double FRAME_S = FrameTime.FRAME_S;
  private static final double MOST = 1.2;
  private static final double CLOSING = 0.25;

  private final CatchUp follower = new CatchUp();

  @Test
  void catchesUpWithARunningBeltAndStaysExactlyWithIt() {
    follower.begin(0);
    double goal = 0;
    for (int frame = 1; frame <= 1000; frame++) {
      goal = frame * 0.3 * FRAME_S;
      follower.step(goal, MOST, CLOSING);
    }
    assertEquals(goal, follower.travel());
    assertEquals(0.3, follower.speed(), 1e-9);
  }

  @Test
  void overshootsByLessThanAMicrometre() {
    follower.begin(0);
    for (int frame = 1; frame <= 1000; frame++) {
      double goal = 0.05;
      follower.step(goal, MOST, CLOSING);
      assertTrue(follower.travel() <= goal + 1e-6, "frame " + frame);
    }
    assertEquals(0.05, follower.travel());
    assertEquals(0, follower.speed());
  }

  @Test
  void neverSpeedsUpMoreThanAllowedWhateverItFollows() {
    long seed = 5;
    SplittableRandom random = new SplittableRandom(seed);
    for (int run = 0; run < 200; run++) {
      follower.begin(0);
      double goal = 0;
      double belt = 0;
      double speed = 0;
      double travel = 0;
      for (int frame = 0; frame < 600; frame++) {
        if (random.nextInt(100) == 0) {
          belt = random.nextDouble(-0.5, 0.5);
        }
        if (random.nextInt(200) == 0) {
          goal += random.nextDouble(-0.1, 0.1);
          follower.rest();
          speed = 0;
        }
        goal += belt * FRAME_S;
        follower.step(goal, MOST, CLOSING);
        String where = "seed " + seed + ", run " + run + ", frame " + frame;
        assertTrue(Math.abs(follower.speed() - speed) <= MOST * FRAME_S * (1 + 1e-9), where);
        assertEquals(follower.speed(), (follower.travel() - travel) / FRAME_S, 1e-9, where);
        speed = follower.speed();
        travel = follower.travel();
      }
      for (int frame = 0; frame < 2500; frame++) {
        goal += belt * FRAME_S;
        follower.step(goal, MOST, CLOSING);
      }
      assertEquals(goal, follower.travel(), "seed " + seed + ", run " + run);
    }
  }
}
