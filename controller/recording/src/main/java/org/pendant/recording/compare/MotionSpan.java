package org.pendant.recording.compare;

import java.util.Optional;
import org.pendant.controller.quantity.StateQuantity;

/**
 * Motion span: when samples of joint speeds leave rest, cross half of a top speed for the first and
 * the last time, and come to rest. Crossings of half the top speed lie on steep flanks, so that
 * they are known far better than the time between two samples; leaving and coming to rest are known
 * to that only.
 */
final class MotionSpan {
  /** Below this part of the top speed a joint should rest. */
  private static final double REST_OF_TARGET = 1e-4;

  /** Below this part of the top speed a joint rests: sensors are never quite still. */
  private static final double REST_OF_SENSOR = 0.02;

  /** A recording whose first sample is above this part of the top speed begins in motion. */
  private static final double IN_MOTION = 0.02;

  private static final double HALF = 0.5;

  private final Samples samples;
  private final StateQuantity speed;
  private final double topRadPerS;
  private final double restRadPerS;

  /**
   * A time that lies between two samples.
   *
   * @param fromS the last sample before it
   * @param toS the first sample after it
   */
  record Between(double fromS, double toS) {
    /** How far a time is outside, s: below 0 before it, above 0 after it. */
    double distanceS(double timeS) {
      return timeS < fromS ? timeS - fromS : Math.max(0, timeS - toS);
    }

    double middleS() {
      return (fromS + toS) / 2;
    }
  }

  /**
   * @param speed of the joints, which the samples have
   * @param topRadPerS the speed that counts as the top, rad/s
   */
  MotionSpan(Samples samples, StateQuantity speed, double topRadPerS) {
    this.samples = samples;
    this.speed = speed;
    this.topRadPerS = topRadPerS;
    boolean target = speed.equals(SampledQuantity.TARGET_QD);
    restRadPerS = topRadPerS * (target ? REST_OF_TARGET : REST_OF_SENSOR);
  }

  /** The largest speed of any joint, rad/s. */
  static double topRadPerS(Samples samples, StateQuantity speed) {
    double top = 0;
    for (int row = 0; row < samples.rows(); row++) {
      top = Math.max(top, norm(samples, speed, row));
    }
    return top;
  }

  /** The speed of the fastest joint in a row, rad/s. */
  static double norm(Samples samples, StateQuantity speed, int row) {
    double norm = 0;
    for (int i = 0; i < speed.size(); i++) {
      norm = Math.max(norm, Math.abs(samples.value(speed, i, row)));
    }
    return norm;
  }

  private double norm(int row) {
    return norm(samples, speed, row);
  }

  /**
   * Whether the first sample is in motion. One that is hardly so was taken just after the start,
   * which is where the arm then was.
   */
  boolean beginsInMotion() {
    return norm(0) >= Math.max(restRadPerS, IN_MOTION * topRadPerS);
  }

  /** Whether the last sample is at rest. */
  boolean endsAtRest() {
    return norm(samples.rows() - 1) < restRadPerS;
  }

  /** When it leaves rest; empty if the first sample is no longer at rest, or it never moves. */
  Optional<Between> start() {
    if (norm(0) >= restRadPerS) {
      return Optional.empty();
    }
    for (int row = 1; row < samples.rows(); row++) {
      if (norm(row) >= restRadPerS) {
        return Optional.of(new Between(samples.timeS(row - 1), samples.timeS(row)));
      }
    }
    return Optional.empty();
  }

  /** When it comes to rest; empty if it is in motion at last, or never moves. */
  Optional<Between> stop() {
    if (!endsAtRest()) {
      return Optional.empty();
    }
    for (int row = samples.rows() - 2; row >= 0; row--) {
      if (norm(row) >= restRadPerS) {
        return Optional.of(new Between(samples.timeS(row), samples.timeS(row + 1)));
      }
    }
    return Optional.empty();
  }

  /** When half the top speed is crossed upwards for the first time, s. */
  Optional<Double> firstHalfS() {
    for (int row = 1; row < samples.rows(); row++) {
      if (norm(row - 1) < HALF * topRadPerS && norm(row) >= HALF * topRadPerS) {
        return Optional.of(crossingS(row - 1));
      }
    }
    return Optional.empty();
  }

  /** When half the top speed is crossed downwards for the last time, s. */
  Optional<Double> lastHalfS() {
    for (int row = samples.rows() - 2; row >= 0; row--) {
      if (norm(row) >= HALF * topRadPerS && norm(row + 1) < HALF * topRadPerS) {
        return Optional.of(crossingS(row));
      }
    }
    return Optional.empty();
  }

  /** On the straight line between a row and the next. */
  private double crossingS(int row) {
    double before = norm(row);
    double after = norm(row + 1);
    double part = (HALF * topRadPerS - before) / (after - before);
    return samples.timeS(row) + part * (samples.timeS(row + 1) - samples.timeS(row));
  }
}
