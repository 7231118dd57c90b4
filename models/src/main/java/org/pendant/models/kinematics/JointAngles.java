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

  /** Whether what belongs to sums of angles is of these joint positions. */
  private boolean summed;

  private double cos23;
  private double sin23;
  private double cos234;
  private double sin234;

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
        SinCos.of(angle, i, sin, cos);
        summed = false;
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

  private void sum() {
    if (summed) {
      return;
    }
    cos23 = cos[1] * cos[2] - sin[1] * sin[2];
    sin23 = sin[1] * cos[2] + cos[1] * sin[2];
    cos234 = cos23 * cos[3] - sin23 * sin[3];
    sin234 = sin23 * cos[3] + cos23 * sin[3];
    summed = true;
  }

  /** Cosine of the angles of shoulder and elbow together, whose axes are parallel. */
  double cos23() {
    sum();
    return cos23;
  }

  /** Sine of the angles of shoulder and elbow together. */
  double sin23() {
    sum();
    return sin23;
  }

  /** Cosine of the angles of shoulder, elbow and first wrist together, whose axes are parallel. */
  double cos234() {
    sum();
    return cos234;
  }

  /** Sine of the angles of shoulder, elbow and first wrist together. */
  double sin234() {
    sum();
    return sin234;
  }
}
