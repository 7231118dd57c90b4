package org.pendant.motion.profile;

/**
 * Profile limits: what a profile may not exceed, and the profiles that come as near to that as they
 * can.
 *
 * <p>A change of speed by d takes the time {@code d / a} with even acceleration. With limited jerk
 * j it takes {@code d / a + a / j} if the acceleration a is reached, which it is when {@code d j >=
 * a²}, and {@code 2 sqrt(d / j)} otherwise; either way it covers the mean of both speeds times its
 * duration. (L. Biagiotti and C. Melchiorri, "Trajectory Planning for Automatic Machines and
 * Robots", Springer 2008, sections 3.2 and 3.4.) At both ends of a profile with limited jerk the
 * acceleration is 0.
 *
 * @param speed per s, above 0
 * @param acceleration per s², above 0
 * @param jerk per s³, above 0; infinite for even acceleration
 */
public record ProfileLimits(double speed, double acceleration, double jerk) {
  /** Halvings of an interval that bring it down to a few rounding errors. */
  private static final int HALVINGS = 60;

  /** Steps that solve a cubic equation from above to a few rounding errors. */
  private static final int NEWTON_STEPS = 6;

  /** Part by which a distance that was found by halving may be too short. */
  private static final double ROUNDING = 1 + 1e-8;

  /** Checks the numbers. */
  public ProfileLimits {
    if (!(speed > 0 && acceleration > 0 && jerk > 0)) {
      throw new IllegalArgumentException(
          "profile limits: speed is "
              + speed
              + ", acceleration "
              + acceleration
              + ", jerk "
              + jerk
              + ", each must be above 0");
    }
  }

  /** Limits without one of the jerk. */
  public static ProfileLimits of(double speed, double acceleration) {
    return new ProfileLimits(speed, acceleration, Double.POSITIVE_INFINITY);
  }

  /** These limits with another speed. */
  public ProfileLimits withSpeed(double limit) {
    return new ProfileLimits(limit, acceleration, jerk);
  }

  /** The fastest profile from rest to rest. */
  public Profile over(double distance) {
    return between(distance, 0, 0);
  }

  /**
   * The fastest profile between two speeds. Where the distance is too short to change from one to
   * the other, the limits of acceleration and jerk give way.
   *
   * @param distance 0 or more
   * @param from speed at the start; may exceed the limit, to which it falls first
   * @param to speed at the end, at most the limit
   */
  public Profile between(double distance, double from, double to) {
    if (distance <= 0) {
      return new Profile.Builder(from).end(0, to);
    }
    if (rampDistance(from, to) > distance * ROUNDING) {
      return forced(distance, from, to);
    }
    double peak = peakSpeed(distance, from, to);
    double even = distance - rampDistance(from, peak) - rampDistance(peak, to);
    Profile.Builder phases = new Profile.Builder(from);
    ramp(phases, from, peak);
    phases.phase(Math.max(0, even) / peak, 0, 0);
    ramp(phases, peak, to);
    return phases.end(distance, to);
  }

  /**
   * The profile from rest to rest that takes a given time. The acceleration and jerk asked for are
   * kept where they suffice; where not, they grow as far as needed.
   *
   * @param distance above 0
   * @param durationS above 0
   */
  public Profile withDuration(double distance, double durationS) {
    return lasting(distance, durationS, 0, 0);
  }

  /** The even change from one speed to another over a distance, whatever acceleration it needs. */
  private static Profile forced(double distance, double from, double to) {
    double lasts = 2 * distance / (from + to);
    return new Profile.Builder(from).phase(lasts, (to - from) / lasts, 0).end(distance, to);
  }

  private Profile lasting(double distance, double durationS, double from, double to) {
    ProfileLimits free = withSpeed(Double.MAX_VALUE);
    double quickest = free.between(distance, from, to).durationS();
    if (quickest >= durationS) {
      double slower = quickest / durationS;
      return new ProfileLimits(
              Double.MAX_VALUE, acceleration * slower * slower, jerk * slower * slower * slower)
          .between(distance, from, to);
    }
    double low = distance / durationS;
    double high = 2 * low;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = 0.5 * (low + high);
      if (withSpeed(middle).between(distance, from, to).durationS() > durationS) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return withSpeed(high).between(distance, from, to);
  }

  /** How long a change of speed takes, s. */
  private double rampS(double from, double to) {
    double change = Math.abs(to - from);
    if (change * jerk >= acceleration * acceleration) {
      return change / acceleration + acceleration / jerk;
    }
    return 2 * Math.sqrt(change / jerk);
  }

  /** The distance that a change of speed takes. */
  public double rampDistance(double from, double to) {
    return from == to ? 0 : 0.5 * (from + to) * rampS(from, to);
  }

  private void ramp(Profile.Builder phases, double from, double to) {
    double change = Math.abs(to - from);
    double sign = Math.signum(to - from);
    if (change == 0) {
      return;
    }
    if (jerk == Double.POSITIVE_INFINITY) {
      phases.phase(change / acceleration, sign * acceleration, 0);
      return;
    }
    boolean reached = change * jerk >= acceleration * acceleration;
    double most = reached ? acceleration : Math.sqrt(change * jerk);
    double grows = most / jerk;
    double stays = reached ? change / acceleration - grows : 0;
    phases
        .phase(grows, 0, sign * jerk)
        .phase(stays, sign * most, 0)
        .phase(grows, sign * most, -sign * jerk);
  }

  /** The highest speed on the way: the limit, or what the distance allows. */
  private double peakSpeed(double distance, double from, double to) {
    if (rampDistance(from, speed) + rampDistance(speed, to) <= distance || speed <= from) {
      return speed <= from ? slowPeak(distance, from, to) : speed;
    }
    if (jerk == Double.POSITIVE_INFINITY) {
      return Math.sqrt(acceleration * distance + 0.5 * (from * from + to * to));
    }
    if (from == 0 && to == 0) {
      return peakFromRest(distance);
    }
    return searched(distance, from, to, Math.max(from, to), speed);
  }

  /** A profile that begins too fast: falls to the limit, or less far where the way is short. */
  private double slowPeak(double distance, double from, double to) {
    if (rampDistance(from, speed) + rampDistance(speed, to) <= distance) {
      return speed;
    }
    return searched(distance, from, to, to, from);
  }

  private double peakFromRest(double distance) {
    double ramp = acceleration * acceleration / jerk;
    if (distance >= 2 * acceleration * ramp / jerk) {
      return 0.5 * (Math.sqrt(ramp * ramp + 4 * acceleration * distance) - ramp);
    }
    return Math.cbrt(distance * distance * jerk / 4);
  }

  private double searched(double distance, double from, double to, double lowest, double highest) {
    double low = lowest;
    double high = highest;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = 0.5 * (low + high);
      if (rampDistance(from, middle) + rampDistance(middle, to) <= distance) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /** The highest speed, at most the limit, from which {@code to} can be reached over a distance. */
  public double fastestBegin(double distance, double to) {
    return fastest(distance, to);
  }

  /** The highest speed, at most the limit, that can be reached from {@code from}. */
  public double fastestEnd(double distance, double from) {
    return fastest(distance, from);
  }

  /** The lowest speed that can be reached from {@code from}, were the jerk no limit. */
  public double slowestEnd(double distance, double from) {
    return Math.sqrt(Math.max(0, from * from - 2 * acceleration * Math.max(0, distance)));
  }

  private double fastest(double distance, double other) {
    if (rampDistance(other, speed) <= distance) {
      return speed;
    }
    if (distance <= 0 || other >= speed) {
      return Math.min(other, speed);
    }
    if (jerk == Double.POSITIVE_INFINITY) {
      return Math.min(speed, Math.sqrt(other * other + 2 * acceleration * distance));
    }
    return Math.min(speed, other + change(distance, other));
  }

  /** By how much the speed can grow from {@code from} over a distance with limited jerk. */
  private double change(double distance, double from) {
    double corner = acceleration * acceleration / jerk;
    if (rampDistance(from, from + corner) <= distance) {
      // v² + v a² / j = from² - from a² / j + 2 a distance, for the change v - from
      double half = from + 0.5 * corner;
      double more = 2 * (acceleration * distance - from * corner);
      return more / (half + Math.sqrt(half * half + more));
    }
    // j x³ + 2 from x = distance, for x = sqrt(change / j)
    double x = Math.cbrt(distance / jerk);
    if (from > 0) {
      x = Math.min(x, 0.5 * distance / from);
      for (int i = 0; i < NEWTON_STEPS; i++) {
        double slope = 3 * jerk * x * x + 2 * from;
        x -= ((jerk * x * x + 2 * from) * x - distance) / slope;
      }
    }
    return jerk * x * x;
  }
}
