package org.pendant.models.dynamics;

import java.util.Arrays;
import org.pendant.models.arm.Joints;

/**
 * Cosines and sines of joint angles, which mass matrix and torques of one posture share: those of
 * an angle are computed again only when it has changed.
 */
final class JointAngles {
  final double[] cos = new double[Joints.COUNT];
  final double[] sin = new double[Joints.COUNT];
  private final double[] q = new double[Joints.COUNT];

  JointAngles() {
    Arrays.fill(cos, 1);
  }

  /** Takes six joint positions, rad. */
  void at(double[] positionRad) {
    for (int i = 0; i < Joints.COUNT; i++) {
      double angle = positionRad[i];
      if (Double.doubleToRawLongBits(angle) != Double.doubleToRawLongBits(q[i])) {
        q[i] = angle;
        cos[i] = Math.cos(angle);
        sin[i] = Math.sin(angle);
      }
    }
  }
}
