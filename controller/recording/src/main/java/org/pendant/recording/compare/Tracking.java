package org.pendant.recording.compare;

import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.pendant.controller.quantity.StateQuantity;

/** Tracking: how the drives of a run follow their targets, at chosen times of it. */
public final class Tracking {
  /** A joint counts as moving above this part of its top speed. */
  private static final double MOVING = 0.05;

  private static final double MIN_SPEED_RAD_PER_S = 0.01;

  private final Samples samples;
  private final double[] timesS;

  /** Tracking in all samples. */
  public Tracking(Samples samples) {
    this(samples, IntStream.range(0, samples.rows()).mapToDouble(samples::timeS).toArray());
  }

  /**
   * @param timesS when they are looked at, by the clock of the samples
   */
  Tracking(Samples samples, double[] timesS) {
    this.samples = samples;
    this.timesS = timesS.clone();
  }

  private double movingAboveRadPerS(int joint) {
    double top = 0;
    for (double timeS : timesS) {
      top = Math.max(top, Math.abs(samples.at(SampledQuantity.TARGET_QD, joint, timeS)));
    }
    return Math.max(MIN_SPEED_RAD_PER_S, MOVING * top);
  }

  /**
   * By how much a joint lags, s: least squares of target less actual position over target speed;
   * empty if it does not move, or if that was not recorded.
   */
  public OptionalDouble lagS(int joint) {
    if (!samples.has(SampledQuantity.TARGET_Q)
        || !samples.has(SampledQuantity.ACTUAL_Q)
        || !samples.has(SampledQuantity.TARGET_QD)) {
      return OptionalDouble.empty();
    }
    double least = movingAboveRadPerS(joint);
    double products = 0;
    double squares = 0;
    for (double timeS : timesS) {
      double speed = samples.at(SampledQuantity.TARGET_QD, joint, timeS);
      if (Math.abs(speed) >= least) {
        double behind =
            samples.at(SampledQuantity.TARGET_Q, joint, timeS)
                - samples.at(SampledQuantity.ACTUAL_Q, joint, timeS);
        products += behind * speed;
        squares += speed * speed;
      }
    }
    return squares > 0 ? OptionalDouble.of(products / squares) : OptionalDouble.empty();
  }

  /**
   * Root of the mean square by which a joint's actual reading differs from its target while the
   * joint moves; empty if it does not move, or if that was not recorded.
   */
  OptionalDouble rms(int joint, StateQuantity target, StateQuantity actual) {
    if (!samples.has(target) || !samples.has(actual) || !samples.has(SampledQuantity.TARGET_QD)) {
      return OptionalDouble.empty();
    }
    double least = movingAboveRadPerS(joint);
    double squares = 0;
    int count = 0;
    for (double timeS : timesS) {
      if (Math.abs(samples.at(SampledQuantity.TARGET_QD, joint, timeS)) >= least) {
        double error = samples.at(actual, joint, timeS) - samples.at(target, joint, timeS);
        squares += error * error;
        count++;
      }
    }
    return count > 0 ? OptionalDouble.of(Math.sqrt(squares / count)) : OptionalDouble.empty();
  }
}
