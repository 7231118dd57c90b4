package org.pendant.desktop.plot;

import org.pendant.controller.state.ArmState;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * How fast the TCP moves, along the axes of the base frame.
 *
 * @param xMPerS along x, m/s
 * @param yMPerS along y, m/s
 * @param zMPerS along z, m/s
 */
record TcpSpeed(double xMPerS, double yMPerS, double zMPerS) {

  /**
   * The actual speed: every joint i turns the TCP about its axis z through its origin p with qd_i,
   * which gives {@code qd_i z x (p_tcp - p)}.
   */
  static TcpSpeed of(ArmState arm) {
    Pose tcp = arm.actualTcpInBase();
    double[][] frames = new double[Joints.COUNT][12];
    arm.kinematics().frames(arm.actualPositionRad().toArray(), frames);
    double x = 0;
    double y = 0;
    double z = 0;
    // joint 0 turns about the base's own z axis, joint i about that of frame i
    double[] joint = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    for (int i = 0; i < Joints.COUNT; i++) {
      double qd = arm.actualSpeedRadPerS().get(i);
      double rx = tcp.x() - joint[9];
      double ry = tcp.y() - joint[10];
      double rz = tcp.z() - joint[11];
      x += qd * (joint[5] * rz - joint[8] * ry);
      y += qd * (joint[8] * rx - joint[2] * rz);
      z += qd * (joint[2] * ry - joint[5] * rx);
      joint = frames[i];
    }
    return new TcpSpeed(x, y, z);
  }

  /** Its length, m/s. */
  double mPerS() {
    return Math.sqrt(xMPerS * xMPerS + yMPerS * yMPerS + zMPerS * zMPerS);
  }
}
