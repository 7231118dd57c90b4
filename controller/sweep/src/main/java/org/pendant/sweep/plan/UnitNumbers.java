package org.pendant.sweep.plan;

/** Unit numbers: random numbers that follow from what they are for, in any order. */
final class UnitNumbers {
  private static final long GOLDEN = 0x9E3779B97F4A7C15L;
  private static final double STEP = 0x1.0p-53;

  private UnitNumbers() {}

  /** A number from 0, and below 1, for one parameter of one run. */
  static double at(long seed, long run, int parameter) {
    return (mixed(seed, parameter, run) >>> 11) * STEP;
  }

  /** 64 bits; the finisher of SplitMix64 (Steele, Lea, Flood, 2014) over each of the three. */
  static long mixed(long seed, long stream, long number) {
    return finish(finish(finish(seed + GOLDEN) + stream * GOLDEN) + number * GOLDEN + GOLDEN);
  }

  private static long finish(long bits) {
    long z = (bits ^ (bits >>> 30)) * 0xBF58476D1CE4E5B9L;
    z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
    return z ^ (z >>> 31);
  }
}
