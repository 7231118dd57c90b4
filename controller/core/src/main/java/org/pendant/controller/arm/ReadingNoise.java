package org.pendant.controller.arm;

import java.util.OptionalDouble;

/**
 * Reading noise: by how much the readings of an arm and its supply err at random.
 *
 * @param measured whether they err as those of recorded arms do; otherwise they are exact
 * @param positionRad standard deviation of each position reading whatever {@code measured} says,
 *     rad, finite and at least 0; empty to go by that
 */
public record ReadingNoise(boolean measured, OptionalDouble positionRad) {
  /** Exact readings. */
  public static final ReadingNoise NONE = new ReadingNoise(false, OptionalDouble.empty());

  /** Readings as those of recorded arms. */
  public static final ReadingNoise MEASURED = new ReadingNoise(true, OptionalDouble.empty());

  /**
   * Checks the deviation.
   *
   * @throws IllegalArgumentException if it is negative or not finite
   */
  public ReadingNoise {
    if (positionRad.isPresent()
        && !(positionRad.getAsDouble() >= 0
            && positionRad.getAsDouble() < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(
          "encoder noise is " + positionRad.getAsDouble() + " rad, must be at least 0");
    }
  }

  /** The same, with {@code standardDeviationRad} for positions. */
  public ReadingNoise withPosition(double standardDeviationRad) {
    return new ReadingNoise(measured, OptionalDouble.of(standardDeviationRad));
  }

  /** The same, with everything else as {@code wanted} says. */
  public ReadingNoise withMeasured(boolean wanted) {
    return new ReadingNoise(wanted, positionRad);
  }
}
