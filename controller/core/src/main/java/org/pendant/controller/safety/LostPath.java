package org.pendant.controller.safety;

import java.util.OptionalInt;
import org.pendant.models.arm.Joints;
import org.pendant.motion.MotionFailure;

/** Lost path: the stop that ends a path which cannot be followed any further. */
final class LostPath {
  private LostPath() {}

  /**
   * The stop.
   *
   * @param targetQ joint positions where the path was left, rad
   */
  static SafetyStop stop(
      MotionFailure failure, double[] targetQ, SafetyLimits limits, double timeS) {
    return switch (failure.code()) {
      case MotionFailure.SINGULARITY -> simple(StopReason.SINGULARITY, failure, timeS);
      case MotionFailure.TOO_FAST -> simple(StopReason.TARGET_SPEED_JUMP, failure, timeS);
      case MotionFailure.RANGE_ENDS ->
          StopReason.JOINT_LIMIT_NEAR.because(
              failure.message(), OptionalInt.of(atItsEnd(targetQ, limits)), timeS);
      default -> simple(StopReason.OUT_OF_REACH, failure, timeS);
    };
  }

  private static SafetyStop simple(StopReason reason, MotionFailure failure, double timeS) {
    return reason.because(failure.message(), OptionalInt.empty(), timeS);
  }

  /** The joint that is nearest to an end of its range. */
  private static int atItsEnd(double[] q, SafetyLimits limits) {
    int nearest = 0;
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < Joints.COUNT; i++) {
      double left =
          Math.min(q[i] - limits.jointMinRad().get(i), limits.jointMaxRad().get(i) - q[i]);
      if (left < least) {
        least = left;
        nearest = i;
      }
    }
    return nearest;
  }
}
