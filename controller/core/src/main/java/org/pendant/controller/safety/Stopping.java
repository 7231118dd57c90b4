package org.pendant.controller.safety;

import org.pendant.models.arm.Joints;

/**
 * Stop on the path: the fastest joint slows down evenly, the others in proportion. The figures are
 * our choice, nothing is published.
 */
final class Stopping {
  /** As hard as the motors can, rad/s². */
  static final double HARD_RAD_PER_S2 = 15;

  /** A gentle stop, rad/s². */
  static final double SOFT_RAD_PER_S2 = 4;

  private Stopping() {}

  /** How long a hard stop takes from these speeds (rad/s), s. */
  static double timeS(double[] qd) {
    return fastest(qd) / HARD_RAD_PER_S2;
  }

  /** The largest of six numbers, signs aside. */
  static double fastest(double[] qd) {
    double fastest = 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      fastest = Math.max(fastest, Math.abs(qd[i]));
    }
    return fastest;
  }
}
