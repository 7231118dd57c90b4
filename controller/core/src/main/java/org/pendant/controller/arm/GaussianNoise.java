package org.pendant.controller.arm;

import java.util.SplittableRandom;

/**
 * Gaussian noise from a seed: the sum of four uniform parts of one random number, which is near
 * enough to a normal distribution for a reading, costs a tenth of it, and never strays beyond 3.5
 * standard deviations.
 */
final class GaussianNoise {
  private static final int PART = 0xFFFF;
  private static final double MIDDLE = 2.0 * PART;

  /** One over the standard deviation of the sum of four even numbers from 0 to 65535. */
  private static final double SCALE = Math.sqrt(3) / (PART + 1);

  private final SplittableRandom random;

  GaussianNoise(long seed) {
    random = new SplittableRandom(seed);
  }

  /** The next number: mean 0, standard deviation 1. */
  double next() {
    long bits = random.nextLong();
    long sum = (bits & PART) + (bits >>> 16 & PART) + (bits >>> 32 & PART) + (bits >>> 48);
    return SCALE * (sum - MIDDLE);
  }

  /** The next number between -1 and 1, all of them as likely. */
  double uniform() {
    return random.nextDouble(-1, 1);
  }

  /** The multiple of {@code step} that is nearest to {@code value}; never -0. */
  static double quantized(double value, double step) {
    return step * Math.rint(value / step) + 0.0;
  }
}
