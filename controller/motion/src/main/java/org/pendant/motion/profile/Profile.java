package org.pendant.motion.profile;

import java.util.Arrays;

/**
 * Motion profile: distance over time in phases of even jerk; mostly made by {@link ProfileLimits}.
 * It is asked at times of the caller's choice and never integrated, so errors do not add up.
 */
public final class Profile {
  /** Halvings of the time that bring it down to a few rounding errors. */
  private static final int HALVINGS = 50;

  private final int phases;
  private final double[] beginS;
  private final double[] position;
  private final double[] speed;
  private final double[] acceleration;
  private final double[] jerk;
  private final double distance;
  private final double endSpeed;
  private final double durationS;
  private final double peakSpeed;

  private Profile(Builder made, double distance, double endSpeed) {
    phases = made.phases;
    beginS = Arrays.copyOf(made.beginS, phases);
    position = Arrays.copyOf(made.position, phases);
    speed = Arrays.copyOf(made.speed, phases);
    acceleration = Arrays.copyOf(made.acceleration, phases);
    jerk = Arrays.copyOf(made.jerk, phases);
    durationS = made.timeS;
    peakSpeed = made.peak;
    this.distance = distance;
    this.endSpeed = endSpeed;
  }

  /** The whole distance. */
  public double distance() {
    return distance;
  }

  /** How long it takes, s. */
  public double durationS() {
    return durationS;
  }

  /** The highest speed that is reached. */
  public double peakSpeed() {
    return peakSpeed;
  }

  /** The strongest acceleration, up or down. */
  public double peakAcceleration() {
    double peak = 0;
    for (int i = 0; i < phases; i++) {
      double endS = i + 1 < phases ? beginS[i + 1] : durationS;
      double end = acceleration[i] + jerk[i] * (endS - beginS[i]);
      peak = Math.max(peak, Math.max(Math.abs(acceleration[i]), Math.abs(end)));
    }
    return peak;
  }

  /** The speed at the end. */
  public double endSpeed() {
    return endSpeed;
  }

  /** Distance covered at a time; 0 before the start, all of it from the end on. */
  public double position(double timeS) {
    if (timeS <= 0) {
      return 0;
    }
    if (timeS >= durationS) {
      return distance;
    }
    int i = phase(timeS);
    double t = timeS - beginS[i];
    return position[i] + t * (speed[i] + t * (acceleration[i] / 2 + t * (jerk[i] / 6)));
  }

  /** When a distance is covered: the time of which {@link #position} is that, s. */
  public double timeAt(double covered) {
    if (covered >= distance) {
      return durationS;
    }
    double low = 0;
    double high = durationS;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = 0.5 * (low + high);
      if (position(middle) <= covered) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /** Speed at a time; after the end the speed there. */
  public double speed(double timeS) {
    if (timeS >= durationS) {
      return endSpeed;
    }
    int i = phase(timeS);
    double t = Math.max(0, timeS - beginS[i]);
    return speed[i] + t * (acceleration[i] + t * (jerk[i] / 2));
  }

  /** Acceleration at a time; 0 at the ends and outside. */
  public double acceleration(double timeS) {
    if (timeS <= 0 || timeS >= durationS) {
      return 0;
    }
    int i = phase(timeS);
    return acceleration[i] + (timeS - beginS[i]) * jerk[i];
  }

  /**
   * The highest acceleration between two times.
   *
   * @param sign 1, or -1 for the lowest one
   */
  public double extremeAcceleration(double fromS, double toS, double sign) {
    double extreme = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < phases; i++) {
      double low = Math.max(fromS, beginS[i]);
      double high = Math.min(toS, i + 1 < phases ? beginS[i + 1] : durationS);
      if (low <= high) {
        extreme = Math.max(extreme, sign * (acceleration[i] + (low - beginS[i]) * jerk[i]));
        extreme = Math.max(extreme, sign * (acceleration[i] + (high - beginS[i]) * jerk[i]));
      }
    }
    return extreme == Double.NEGATIVE_INFINITY ? 0 : sign * extreme;
  }

  private int phase(double timeS) {
    int i = phases - 1;
    while (i > 0 && beginS[i] > timeS) {
      i--;
    }
    return i;
  }

  /** Puts phases one after another. */
  static final class Builder {
    /** A ramp up, an even part and a ramp down. */
    private static final int MAX_PHASES = 7;

    private final double[] beginS = new double[MAX_PHASES];
    private final double[] position = new double[MAX_PHASES];
    private final double[] speed = new double[MAX_PHASES];
    private final double[] acceleration = new double[MAX_PHASES];
    private final double[] jerk = new double[MAX_PHASES];
    private int phases;
    private double timeS;
    private double covered;
    private double now;
    private double peak;

    Builder(double beginSpeed) {
      now = beginSpeed;
      peak = beginSpeed;
    }

    /** Continues for a time with an acceleration that changes evenly; not at all for no time. */
    Builder phase(double lengthS, double beginAcceleration, double evenJerk) {
      if (lengthS > 0) {
        beginS[phases] = timeS;
        position[phases] = covered;
        speed[phases] = now;
        acceleration[phases] = beginAcceleration;
        jerk[phases] = evenJerk;
        phases++;
        covered += lengthS * (now + lengthS * (beginAcceleration / 2 + lengthS * (evenJerk / 6)));
        now += lengthS * (beginAcceleration + lengthS * (evenJerk / 2));
        timeS += lengthS;
        peak = Math.max(peak, now);
      }
      return this;
    }

    /** The profile; the sums of the phases are replaced by what they should come to. */
    Profile end(double distance, double endSpeed) {
      if (phases == 0) {
        phases = 1; // a profile of no length, which still has a phase to ask
      }
      return new Profile(this, distance, endSpeed);
    }
  }
}
