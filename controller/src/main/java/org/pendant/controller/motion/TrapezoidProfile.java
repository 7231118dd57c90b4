package org.pendant.controller.motion;

/**
 * Distance over time from rest to rest: even acceleration, constant speed, even deceleration.
 *
 * <p>With distance D, speed v and acceleration a, the speed v is reached if {@code a D >= v²}; then
 * the ramps take {@code v / a} each and the whole {@code D / v + v / a}. Otherwise the profile is a
 * triangle with the peak {@code sqrt(a D)}. Units are those of D, per s and per s². (B. Siciliano
 * et al., "Robotics: Modelling, Planning and Control", section 4.2.1.)
 */
public final class TrapezoidProfile {
  private final double distance;
  private final double cruiseSpeed;
  private final double acceleration;
  private final double rampS;
  private final double durationS;

  private TrapezoidProfile(
      double distance, double cruiseSpeed, double acceleration, double rampS, double durationS) {
    this.distance = distance;
    this.cruiseSpeed = cruiseSpeed;
    this.acceleration = acceleration;
    this.rampS = rampS;
    this.durationS = durationS;
  }

  /**
   * The fastest profile within a speed and an acceleration.
   *
   * @param distance 0 or more
   * @param speed above 0
   * @param acceleration above 0
   */
  public static TrapezoidProfile of(double distance, double speed, double acceleration) {
    if (distance == 0) {
      return new TrapezoidProfile(0, 0, acceleration, 0, 0);
    }
    if (distance * acceleration >= speed * speed) {
      double ramp = speed / acceleration;
      return new TrapezoidProfile(distance, speed, acceleration, ramp, distance / speed + ramp);
    }
    double ramp = Math.sqrt(distance / acceleration);
    return new TrapezoidProfile(distance, acceleration * ramp, acceleration, ramp, 2 * ramp);
  }

  /**
   * The profile that takes a given time. The acceleration asked for is kept where it suffices;
   * where it does not, the profile is a triangle with the least acceleration that does.
   *
   * @param distance 0 or more
   * @param durationS above 0
   * @param acceleration above 0, or 0 for the least that suffices
   */
  public static TrapezoidProfile withDuration(
      double distance, double durationS, double acceleration) {
    double least = 4 * distance / durationS / durationS;
    if (!(acceleration > least)) {
      return new TrapezoidProfile(
          distance, 2 * distance / durationS, least, durationS / 2, durationS);
    }
    // the smaller root of v² - a T v + a D = 0, written so that nothing cancels
    double root = Math.sqrt(durationS * durationS - 4 * distance / acceleration);
    double speed = 2 * distance / (durationS + root);
    return new TrapezoidProfile(distance, speed, acceleration, speed / acceleration, durationS);
  }

  /** The whole distance. */
  public double distance() {
    return distance;
  }

  /** The highest speed that is reached. */
  public double cruiseSpeed() {
    return cruiseSpeed;
  }

  /** Acceleration in the first ramp, deceleration in the last. */
  public double acceleration() {
    return acceleration;
  }

  /** How long it takes, s. */
  public double durationS() {
    return durationS;
  }

  /** Distance covered at a time; 0 before the start, all of it after the end. */
  public double position(double timeS) {
    if (timeS <= 0) {
      return 0;
    }
    if (timeS >= durationS) {
      return distance;
    }
    if (timeS < rampS) {
      return 0.5 * acceleration * timeS * timeS;
    }
    double left = durationS - timeS;
    if (left < rampS) {
      return distance - 0.5 * acceleration * left * left;
    }
    return cruiseSpeed * (timeS - 0.5 * rampS);
  }

  /** Speed at a time. */
  public double speed(double timeS) {
    if (timeS <= 0 || timeS >= durationS) {
      return 0;
    }
    double ramped = Math.min(timeS, durationS - timeS);
    return ramped < rampS ? acceleration * ramped : cruiseSpeed;
  }

  /** Acceleration at a time; 0 at the ends and outside. */
  public double acceleration(double timeS) {
    if (timeS <= 0 || timeS >= durationS) {
      return 0;
    }
    if (timeS < rampS) {
      return acceleration;
    }
    return durationS - timeS < rampS ? -acceleration : 0;
  }
}
