package org.pendant.recording.compare;

import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.models.arm.Joints;

/**
 * Start of a run: what the recording says of where the arm was and what it carried when its program
 * began.
 */
public final class StartOfRun {
  /** How long before a recording that begins in motion its program is started, s. */
  private static final double BEFORE_S = 1;

  private StartOfRun() {}

  /**
   * Positions of encoders are differentiated over at least this time, s, or noise is all there is.
   */
  private static final double SLOPE_S = 0.02;

  /** Whether the arm rests in the first sample, or hardly moves yet. */
  public static boolean atRest(Samples recorded) {
    StateQuantity speed = SampledQuantity.speed(recorded).orElseThrow();
    double top = MotionSpan.topRadPerS(recorded, speed);
    return top == 0 || !new MotionSpan(recorded, speed, top).beginsInMotion();
  }

  /**
   * Where the joints are at first, rad. A recording that begins in motion does not tell: then it is
   * a place from which the joints get to the first sample on a straight line, as they do in a move
   * of joints.
   */
  public static Joints positionRad(Samples recorded) {
    StateQuantity position =
        recorded.has(SampledQuantity.TARGET_Q)
            ? SampledQuantity.TARGET_Q
            : SampledQuantity.ACTUAL_Q;
    double[] q = recorded.values(position, 0);
    if (!atRest(recorded)) {
      StateQuantity speed = SampledQuantity.speed(recorded).orElseThrow();
      for (int i = 0; i < q.length; i++) {
        q[i] -= BEFORE_S * recorded.value(speed, i, 0);
      }
    }
    return Joints.of(q);
  }

  /** Where the speed slider was, 0 to 1; empty where that was not recorded. */
  public static OptionalDouble speedFraction(Samples recorded) {
    return recorded.has(SampledQuantity.SPEED_SLIDER)
        ? OptionalDouble.of(recorded.value(SampledQuantity.SPEED_SLIDER, 0, 0))
        : OptionalDouble.empty();
  }

  /** What the payload was declared to be, kg; empty where that was not recorded. */
  public static OptionalDouble payloadKg(Samples recorded) {
    return recorded.has(SampledQuantity.PAYLOAD)
        ? OptionalDouble.of(recorded.value(SampledQuantity.PAYLOAD, 0, 0))
        : OptionalDouble.empty();
  }

  /** Its centre of gravity in the flange frame, m; empty where that was not recorded. */
  public static Optional<double[]> cogM(Samples recorded) {
    return recorded.has(SampledQuantity.PAYLOAD_COG)
        ? Optional.of(recorded.values(SampledQuantity.PAYLOAD_COG, 0))
        : Optional.empty();
  }

  /** The same samples, with joint speeds that are worked out where none were recorded. */
  public static Samples withSpeeds(Samples recorded) {
    if (SampledQuantity.speed(recorded).isPresent()) {
      return recorded;
    }
    StateQuantity position =
        recorded.has(SampledQuantity.ACTUAL_Q)
            ? SampledQuantity.ACTUAL_Q
            : SampledQuantity.TARGET_Q;
    double[][] speeds = new double[position.size()][recorded.rows()];
    for (int row = 0; row < recorded.rows(); row++) {
      int before = Math.max(0, row - 1);
      int after = Math.min(recorded.rows() - 1, row + 1);
      while (recorded.timeS(after) - recorded.timeS(before) < SLOPE_S
          && before > 0
          && after < recorded.rows() - 1) {
        before--;
        after++;
      }
      double timeS = recorded.timeS(after) - recorded.timeS(before);
      for (int i = 0; i < speeds.length; i++) {
        double way = recorded.value(position, i, after) - recorded.value(position, i, before);
        speeds[i][row] = way / timeS;
      }
    }
    return recorded.with(
        position.equals(SampledQuantity.ACTUAL_Q)
            ? SampledQuantity.ACTUAL_QD
            : SampledQuantity.TARGET_QD,
        speeds);
  }
}
