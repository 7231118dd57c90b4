package org.pendant.controller.arm;

import java.util.SplittableRandom;
import org.pendant.models.arm.Joints;

/**
 * Held friction: what the motors keep giving against the dry friction of joints that have come to
 * rest. As an arm stops, part of the torque that turned a joint stays between its motor and its dry
 * friction, with the sign of its last motion and of another size after every stop; it moves
 * nothing, since the friction holds.
 */
final class HeldFriction {
  /** Target speed above which a joint slides, and its dry friction is fed forward, rad/s. */
  private static final double SLIDING_RAD_PER_S = 1e-4;

  /** Least and largest share of the dry friction that stays. */
  private static final double MIN_SHARE = 0.4;

  private static final double MAX_SHARE = 0.98;

  private final SplittableRandom random;
  private final double[] share = new double[Joints.COUNT];
  private final boolean[] slides = new boolean[Joints.COUNT];

  HeldFriction(SplittableRandom random) {
    this.random = random;
  }

  /** Forgets what was held: the brakes took over, or nothing holds a position. */
  void release() {
    for (int i = 0; i < Joints.COUNT; i++) {
      share[i] = 0;
      slides[i] = false;
    }
  }

  /**
   * The share of its dry friction that the motor of a joint gives.
   *
   * @param speedRadPerS target speed, rad/s
   * @return -1 to 1, along the motion
   */
  double share(int joint, double speedRadPerS) {
    double sliding = speedRadPerS / SLIDING_RAD_PER_S;
    if (Math.abs(sliding) >= 1) {
      slides[joint] = true;
      share[joint] = Math.signum(speedRadPerS);
      return share[joint];
    }
    if (slides[joint]) {
      slides[joint] = false;
      share[joint] *= random.nextDouble(MIN_SHARE, MAX_SHARE);
    }
    return sliding + (1 - Math.abs(sliding)) * share[joint];
  }
}
