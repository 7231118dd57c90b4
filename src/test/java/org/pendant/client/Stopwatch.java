package org.pendant.client;

import java.util.Arrays;
import java.util.Locale;

/** When messages arrived that should come every 2 ms, and how far from that they were. */
final class Stopwatch {
  private static final double MESSAGE_NS = 2e6;

  private final long[] arrivedNs;
  private int count;

  /**
   * An empty one.
   *
   * @param most of more arrivals only the first ones are kept
   */
  Stopwatch(int most) {
    arrivedNs = new long[most];
  }

  /** A message has arrived now. */
  void arrived() {
    if (count < arrivedNs.length) {
      arrivedNs[count++] = System.nanoTime();
    }
  }

  /** How many messages have arrived. */
  int count() {
    return count;
  }

  /** Messages a second. */
  double rateHz() {
    return (count - 1) * 1e9 / (arrivedNs[count - 1] - arrivedNs[0]);
  }

  /** Of all intervals, this part is wrong by at most the answer, ms. */
  double intervalErrorMs(double part) {
    double[] errors = new double[count - 1];
    for (int i = 0; i < errors.length; i++) {
      errors[i] = Math.abs(arrivedNs[i + 1] - arrivedNs[i] - MESSAGE_NS) / 1e6;
    }
    Arrays.sort(errors);
    return errors[(int) Math.min(errors.length - 1, Math.round(part * errors.length))];
  }

  /** The cells of a row: rate, 95th and 99th percentile of the intervals' errors, the worst. */
  String cells() {
    return String.format(
        Locale.ROOT,
        "%.2f Hz | %.3f ms | %.3f ms | %.1f ms",
        rateHz(),
        intervalErrorMs(0.95),
        intervalErrorMs(0.99),
        intervalErrorMs(1));
  }
}
