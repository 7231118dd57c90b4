package org.pendant.controller.safety;

import java.util.Arrays;
import java.util.Optional;
import org.pendant.models.arm.Joints;

/**
 * Deviation warnings: warns of joints that are away from their targets (manual 15.41), each at most
 * once a second: the log is for people.
 */
final class DeviationWarnings {
  static final double PAUSE_S = 1;

  private final double[] nextS = new double[Joints.COUNT];
  private boolean enabled;
  private double threshold;

  DeviationWarnings() {
    Arrays.fill(nextS, Double.NEGATIVE_INFINITY);
  }

  void set(boolean on, double share) {
    enabled = on;
    threshold = share;
    Arrays.fill(nextS, Double.NEGATIVE_INFINITY);
  }

  /** The first joint that is worth a warning now, if one is. */
  Optional<SafetyStop> check(double timeS, Observation seen, boolean holding) {
    if (!enabled) {
      return Optional.empty();
    }
    for (int i = 0; i < Joints.COUNT; i++) {
      double deviation = Math.abs(seen.targetQ[i] - seen.q[i]);
      double limit = threshold * FollowingCheck.allowedDeviationRad(i, holding);
      if (deviation > limit && timeS >= nextS[i]) {
        nextS[i] = timeS + PAUSE_S;
        return Optional.of(StopReason.DEVIATION_WARNING.ofJoint(i, timeS, deviation, limit));
      }
    }
    return Optional.empty();
  }
}
