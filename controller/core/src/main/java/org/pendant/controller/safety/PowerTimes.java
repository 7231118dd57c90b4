package org.pendant.controller.safety;

import static org.pendant.controller.safety.SafetyTexts.text;

/**
 * Power times: how long changes of power take, s. What a safety function demands takes no time in
 * any case.
 *
 * @param bootS from the command until the arm's electronics answer
 * @param powerOnS from then until the arm rests on its brakes with power
 * @param brakeS from the command until the brakes are released
 * @param offS from the command until the power is cut
 * @param unlockS from the command until a protective stop has ended
 */
public record PowerTimes(
    double bootS, double powerOnS, double brakeS, double offS, double unlockS) {
  /** Until an arm that was off can move, without its last steps: cutting power and unlocking. */
  private static final double ON_S = 2.6;

  private static final double MAX_S = 60;

  /** As the other end of a network sees them on a real box: nothing changes at once. */
  public static final PowerTimes REAL = new PowerTimes(1.0, 0.6, 1.0, 0.1, 0.1);

  /** As {@link #REAL}, but cutting the power and unlocking take no time. */
  public static final PowerTimes STANDARD = new PowerTimes(1.0, 0.6, 1.0, 0, 0);

  /**
   * Checks the range.
   *
   * @throws IllegalArgumentException if a time is negative or above 60 s
   */
  public PowerTimes {
    check("bootS", bootS);
    check("powerOnS", powerOnS);
    check("brakeS", brakeS);
    check("offS", offS);
    check("unlockS", unlockS);
  }

  private static void check(String name, double timeS) {
    if (!inRange(timeS)) {
      throw new IllegalArgumentException(name + " is " + timeS + ", must be 0 to " + MAX_S);
    }
  }

  private static boolean inRange(double timeS) {
    return timeS >= 0 && timeS <= MAX_S;
  }

  /**
   * Those of a box that takes {@code totalS} from POWER_OFF to RUNNING, the others in proportion to
   * {@link #REAL}.
   *
   * @param totalS 0 to 60 s
   * @throws IllegalArgumentException if it is not in this range
   */
  public static PowerTimes ofTotal(double totalS) {
    if (!inRange(totalS)) {
      throw new IllegalArgumentException(text("timeToSwitchOn", totalS, MAX_S));
    }
    double share = totalS / ON_S;
    return new PowerTimes(
        REAL.bootS * share,
        REAL.powerOnS * share,
        REAL.brakeS * share,
        REAL.offS * share,
        REAL.unlockS * share);
  }
}
