package org.pendant.desktop.move;

import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.Rotations;

/** Tool alignment: turns the tool so that its z axis is parallel to an axis of the base. */
final class ToolAlignment {
  /** Below this sine (rad) the tool is aligned. */
  private static final double ALIGNED = 1e-9;

  private ToolAlignment() {}

  /**
   * The pose with the least turn that aligns the tool with the nearest axis; the TCP stays.
   *
   * @param tcpInBase the pose of the TCP
   */
  static Pose nearest(Pose tcpInBase) {
    double[] matrix = new double[9];
    Rotations.vectorToMatrix(tcpInBase.rx(), tcpInBase.ry(), tcpInBase.rz(), matrix);
    double[] z = {matrix[2], matrix[5], matrix[8]};
    double[] axis = nearestAxis(z);
    double x = z[1] * axis[2] - z[2] * axis[1];
    double y = z[2] * axis[0] - z[0] * axis[2];
    double w = z[0] * axis[1] - z[1] * axis[0];
    double sine = Math.sqrt(x * x + y * y + w * w);
    if (sine < ALIGNED) {
      return tcpInBase;
    }
    double factor = Math.asin(Math.min(1, sine)) / sine;
    Pose turn = new Pose(0, 0, 0, factor * x, factor * y, factor * w);
    return Poses.add(turn, tcpInBase);
  }

  private static double[] nearestAxis(double[] z) {
    int best = 0;
    for (int i = 1; i < 3; i++) {
      if (Math.abs(z[i]) > Math.abs(z[best])) {
        best = i;
      }
    }
    double[] axis = new double[3];
    axis[best] = Math.signum(z[best]);
    return axis;
  }
}
