package org.pendant.controller.freedrive;

import org.pendant.controller.safety.SafetyLimits;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;

/**
 * Joint limit springs: the nearer a guided joint comes to the end of its range, the slower it may
 * turn towards it, and at the end a spring pushes it back. A joint that is beyond the spring's
 * beginning when freedrive starts is kept from going further, and the spring follows it inwards.
 */
final class JointLimitSprings {
  /** How far before the end of its range a joint meets the wall, rad. */
  static final double MARGIN_RAD = 0.05;

  /** Close to a wall: speed allowed for each rad of distance, 1/s. */
  private static final double RATE_PER_S = 4;

  /** Farther away: speed from which this deceleration leads to the wall, rad/s². */
  private static final double DECELERATION_RAD_PER_S2 = 3;

  /** Where the two meet, rad. */
  private static final double MEET_RAD = DECELERATION_RAD_PER_S2 / (RATE_PER_S * RATE_PER_S);

  private static final int N = Joints.COUNT;

  private final ArmDescription arm;
  private final double[] low = new double[N];
  private final double[] high = new double[N];

  JointLimitSprings(ArmDescription arm) {
    this.arm = arm;
  }

  /** Freedrive begins here. */
  void begin(double[] q) {
    System.arraycopy(q, 0, low, 0, N);
    System.arraycopy(q, 0, high, 0, N);
  }

  /** Looks at the limits that hold, and where the joints are, rad. */
  void update(SafetyLimits limits, double[] q) {
    for (int i = 0; i < N; i++) {
      JointLimits own = arm.joints().get(i);
      double least = Math.max(own.lowestRad(), limits.jointMinRad().get(i)) + MARGIN_RAD;
      double most = Math.min(own.highestRad(), limits.jointMaxRad().get(i)) - MARGIN_RAD;
      low[i] = Math.min(least, Math.max(low[i], q[i]));
      high[i] = Math.max(most, Math.min(high[i], q[i]));
    }
  }

  /** The largest speed that joint i may have at a position, rad/s; below 0 beyond the wall. */
  double mostRadPerS(int i, double q) {
    return towards(high[i] - q);
  }

  /** The least speed that joint i may have at a position, rad/s. */
  double leastRadPerS(int i, double q) {
    return -towards(q - low[i]);
  }

  private static double towards(double distanceRad) {
    return distanceRad < MEET_RAD
        ? RATE_PER_S * distanceRad
        : Math.sqrt(2 * DECELERATION_RAD_PER_S2 * (distanceRad - MEET_RAD / 2));
  }
}
