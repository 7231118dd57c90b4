package org.pendant.controller.motion;

/**
 * How fast a move may be; for a joint move in rad, for a linear one in m.
 *
 * @param acceleration of the leading axis or the tool, per s²; above 0, or 0 when a duration is
 *     given and no acceleration
 * @param speed per s, above 0; not used when a duration is given
 * @param durationS how long the move takes, s; 0 when acceleration and speed decide
 */
public record MoveLimits(double acceleration, double speed, double durationS) {
  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if one is out of its range
   */
  public MoveLimits {
    boolean timed = durationS > 0;
    boolean fits = timed ? acceleration >= 0 : acceleration > 0 && speed > 0;
    if (!fits || !(durationS >= 0)) {
      throw new IllegalArgumentException(
          "move limits: acceleration is "
              + acceleration
              + ", speed "
              + speed
              + ", duration "
              + durationS
              + ", must be above 0, the last may be 0");
    }
  }

  /** Whether the duration decides. */
  public boolean timed() {
    return durationS > 0;
  }

  /** The profile over a distance. */
  TrapezoidProfile over(double distance) {
    return timed()
        ? TrapezoidProfile.withDuration(distance, durationS, acceleration)
        : TrapezoidProfile.of(distance, speed, acceleration);
  }
}
