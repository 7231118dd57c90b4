package org.pendant.motion;

import org.pendant.motion.profile.ProfileLimits;

/**
 * Speed and acceleration limits of a move; for a joint move in rad, for a linear one in m.
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

  /**
   * The limits over a distance.
   *
   * @param distance 0 or more
   * @param restingEnds at how many of its ends the move rests, 0 to 2
   * @param fastest what the arm can do, per s
   * @param strongest acceleration that a duration alone may lead to, per s²
   */
  ProfileLimits over(double distance, int restingEnds, double fastest, double strongest) {
    if (!timed()) {
      return ProfileLimits.of(Math.min(speed, fastest), acceleration);
    }
    double needed = Math.min(4 * distance / durationS / durationS, strongest);
    double enough = Math.max(acceleration, Math.max(needed, Double.MIN_NORMAL));
    // the smaller root of n v² - 2 a T v + 2 a D = 0, written so that nothing cancels
    double root = Math.sqrt(durationS * durationS - 2 * restingEnds * distance / enough);
    double cruise = 2 * distance / (durationS + (Double.isNaN(root) ? 0 : root));
    return ProfileLimits.of(Math.min(Math.max(cruise, Double.MIN_NORMAL), fastest), enough);
  }
}
