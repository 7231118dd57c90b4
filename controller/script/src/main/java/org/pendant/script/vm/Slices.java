package org.pendant.script.vm;

/**
 * Time slices: how the computing time of a frame is shared out among threads, in nanoseconds as
 * {@link Cost} counts them.
 *
 * @param computingNs what the threads share that had not come to an end in the frame before
 * @param wakingNs what the threads share that waited, one after the other a quarter of the rest
 */
record Slices(int computingNs, int wakingNs) {
  /** So that a primary program leaves most of the 2 ms of a frame to everything else. */
  static final Slices PRIMARY = new Slices(320_000, 320_000);

  /** A secondary program runs for one frame only, a single thread. */
  static final Slices SECONDARY = new Slices(1_000_000, 4_000_000);

  /** For a run whose code is executed without its scheduler. */
  static final Slices NONE = new Slices(0, 0);

  /** What threads that waited get when their share is used up. */
  private static final int MIN_NS = 1000;

  /** How many of them get that in a frame. */
  private static final int MAX_WITH_LEAST = 200;

  private static final int SHARE = 4;

  /** The slice of one of {@code count} threads that continue computing. */
  int computing(int count) {
    return computingNs / Math.max(1, count);
  }

  /**
   * The slice of a thread that has waited, or is new, when {@code leftNs} of {@link #wakingNs} is
   * left; 0 when it has to wait for the next frame.
   */
  int waking(int leftNs) {
    if (leftNs < -MIN_NS * MAX_WITH_LEAST) {
      return 0;
    }
    return Math.max(MIN_NS, leftNs / SHARE);
  }
}
