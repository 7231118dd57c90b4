package org.pendant.models.kinematics;

import java.util.Arrays;
import org.pendant.models.arm.Joints;

/**
 * Joint angles: cosines and sines of a posture, shared by what is computed of it. Those of an angle
 * are computed again only when it has changed. Must not be used by two threads at once.
 */
public final class JointAngles {
  private final double[] cos = new double[Joints.COUNT];
  private final double[] sin = new double[Joints.COUNT];
  private final double[] q = new double[Joints.COUNT];

  /** Those of an arm with all joints at 0. */
  public JointAngles() {
    Arrays.fill(cos, 1);
  }

  /** Takes six joint positions, rad. */
  public void at(double[] positionRad) {
    for (int i = 0; i < Joints.COUNT; i++) {
      double angle = positionRad[i];
      if (Double.doubleToRawLongBits(angle) != Double.doubleToRawLongBits(q[i])) {
        q[i] = angle;
        cos[i] = Math.cos(angle);
        sin[i] = Math.sin(angle);
      }
    }
  }

  /** Cosine of the angle of a joint, 0 to 5. */
  public double cos(int joint) {
    return cos[joint];
  }

  /** Sine of the angle of a joint, 0 to 5. */
  public double sin(int joint) {
    return sin[joint];
  }
}
