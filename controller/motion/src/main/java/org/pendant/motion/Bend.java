package org.pendant.motion;

/**
 * Speed change in a blend: how the acceleration comes and goes, all at once and evenly, or without
 * a jump, {@code 6 u (1 - u)} times the mean over the share u of its time. The jerk of the latter
 * is highest at both ends.
 *
 * @param rampS how long the acceleration of the moves takes to grow to its limit, s; 0 for at once
 */
record Bend(double rampS) {
  private static final double PEAK_OVER_MEAN = 1.5;

  /** Jerk at the ends of a smooth blend, in peaks of its acceleration over its duration. */
  private static final double JERK = 4;

  /** The bend between two moves. */
  static Bend between(Move leaving, Move move) {
    return new Bend(Math.max(leaving.jerkRampS(), move.jerkRampS()));
  }

  boolean smooth() {
    return rampS > 0;
  }

  /**
   * How strong a blend is, in terms of what may be used: 1 where it needs all of either
   * acceleration or jerk.
   *
   * @param perS the change of speed, as a share of the acceleration that may be used; s
   * @param lastsS how long the blend takes, s
   */
  double strength(double perS, double lastsS) {
    double mean = perS / lastsS;
    return smooth() ? PEAK_OVER_MEAN * mean * Math.max(1, JERK * rampS / lastsS) : mean;
  }

  /**
   * The highest rate for a strength of 1, when the blend takes {@code 2 left / rate}.
   *
   * @param perRateS the change of speed for a rate of 1, as a share of the acceleration
   */
  double highestRate(double left, double perRateS) {
    double even = 2 * left / perRateS;
    return smooth()
        ? Math.min(
            Math.sqrt(even / PEAK_OVER_MEAN),
            Math.cbrt(2 * left * even / (PEAK_OVER_MEAN * JERK * rampS)))
        : Math.sqrt(even);
  }

  /** The shortest way that {@link #highestRate} allows a rate for. */
  double shortestLeft(double rate, double perRateS) {
    double even = 0.5 * perRateS * rate * rate;
    return smooth()
        ? Math.max(
            PEAK_OVER_MEAN * even,
            rate * Math.sqrt(0.5 * even * PEAK_OVER_MEAN * JERK * rampS / rate))
        : even;
  }
}
