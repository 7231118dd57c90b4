package org.pendant.recording.whatif;

import java.util.Arrays;

/**
 * Rounds: how often the main thread came to each line, and when, to tell how long a program that
 * never ends takes for one round. Mutable.
 */
final class Rounds {
  private static final int STRIDE = 3;

  /** Count, first and last frame of each line. */
  private long[] numbers = new long[0];

  private int line;

  /**
   * A round of a program.
   *
   * @param line at which it is counted
   * @param frames how many one took, on average
   */
  record Round(int line, double frames) {
    /** There was none. */
    static final Round NONE = new Round(0, 0);
  }

  /** The main thread is on a line, 0 for none, in a frame. */
  void see(int at, long frame) {
    if (at == line) {
      return;
    }
    line = at;
    if (STRIDE * at >= numbers.length) {
      numbers = Arrays.copyOf(numbers, Math.max(STRIDE * (at + 1), 2 * numbers.length));
    }
    if (numbers[STRIDE * at]++ == 0) {
      numbers[STRIDE * at + 1] = frame;
    }
    numbers[STRIDE * at + 2] = frame;
  }

  /** A round of what is repeated the least often: inner loops go round more often. */
  Round round() {
    int best = 0;
    for (int i = 1; STRIDE * i < numbers.length; i++) {
      if (numbers[STRIDE * i] >= 2 && (best == 0 || numbers[STRIDE * i] < numbers[STRIDE * best])) {
        best = i;
      }
    }
    if (best == 0) {
      return Round.NONE;
    }
    long frames = numbers[STRIDE * best + 2] - numbers[STRIDE * best + 1];
    return new Round(best, frames / (double) (numbers[STRIDE * best] - 1));
  }
}
