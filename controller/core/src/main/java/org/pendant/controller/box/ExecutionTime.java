package org.pendant.controller.box;

import java.util.SplittableRandom;

/**
 * Execution time of a frame in virtual time, where the computer's own would make no two runs alike:
 * as long as recorded control boxes take, or nothing at all.
 *
 * <p>Belongs to the thread of the frame loop.
 */
final class ExecutionTime {
  private static final double IDLE_S = 0.43e-3;
  private static final double RUNNING_S = 0.82e-3;

  /** A frame takes as much more or less at most, as a share. */
  private static final double SPREAD = 0.25;

  private final boolean measured;
  private final SplittableRandom random;
  private double spread;

  /**
   * That of a box.
   *
   * @param measured whether frames take what recorded boxes take; otherwise nothing
   */
  ExecutionTime(boolean measured, long seed) {
    this.measured = measured;
    random = new SplittableRandom(Long.reverse(seed) + 2);
  }

  void beginFrame() {
    if (measured) {
      // most frames are near the middle
      spread = SPREAD * (random.nextDouble(-0.5, 0.5) + random.nextDouble(-0.5, 0.5));
    }
  }

  /** How long the box works at this frame, s. */
  double seconds(boolean programRuns) {
    return measured ? (programRuns ? RUNNING_S : IDLE_S) * (1 + spread) : 0;
  }
}
