package org.pendant.controller.safety;

import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Where tool and elbow are and how they move, for one state of the joints; all in the base frame.
 * The elbow is the origin of Denavit-Hartenberg frame 2, the end of the upper arm. Mutable, and
 * allocates nothing after it was made.
 */
final class ArmPoints {
  private static final int FLANGE = Joints.COUNT - 1;
  private static final int ELBOW = 1;

  private final ForwardKinematics forward;
  private final double[][] frames = new double[Joints.COUNT][Transforms.SIZE];
  private final double[] tool = new double[3];
  private final double[] toolSpeed = new double[3];
  private final double[] turn = new double[3];
  private final double[] elbowSpeed = new double[3];
  private final double[] toolAxis = new double[3];

  ArmPoints(ArmDescription arm) {
    forward = new ForwardKinematics(arm.dh());
  }

  /**
   * Looks at a state.
   *
   * @param q six joint positions, rad
   * @param qd six joint speeds, rad/s
   */
  void at(double[] q, double[] qd, Pose tcpInFlange) {
    forward.frames(q, frames);
    double[] flange = frames[FLANGE];
    for (int row = 0; row < 3; row++) {
      tool[row] =
          flange[9 + row]
              + flange[3 * row] * tcpInFlange.x()
              + flange[3 * row + 1] * tcpInFlange.y()
              + flange[3 * row + 2] * tcpInFlange.z();
      toolSpeed[row] = 0;
      elbowSpeed[row] = 0;
      turn[row] = 0;
    }
    addJoint(0, 0, 1, 0, 0, 0, qd[0], true);
    for (int i = 1; i < Joints.COUNT; i++) {
      double[] f = frames[i - 1];
      addJoint(f[2], f[5], f[8], f[9], f[10], f[11], qd[i], i <= ELBOW);
    }
  }

  /** Adds what a joint with axis z through p does at a speed: z x (point - p), and z. */
  private void addJoint(
      double zx,
      double zy,
      double zz,
      double px,
      double py,
      double pz,
      double speed,
      boolean movesElbow) {
    double wx = zx * speed;
    double wy = zy * speed;
    double wz = zz * speed;
    turn[0] += wx;
    turn[1] += wy;
    turn[2] += wz;
    double rx = tool[0] - px;
    double ry = tool[1] - py;
    double rz = tool[2] - pz;
    toolSpeed[0] += wy * rz - wz * ry;
    toolSpeed[1] += wz * rx - wx * rz;
    toolSpeed[2] += wx * ry - wy * rx;
    if (movesElbow) {
      double ex = frames[ELBOW][9] - px;
      double ey = frames[ELBOW][10] - py;
      double ez = frames[ELBOW][11] - pz;
      elbowSpeed[0] += wy * ez - wz * ey;
      elbowSpeed[1] += wz * ex - wx * ez;
      elbowSpeed[2] += wx * ey - wy * ex;
    }
  }

  /** Points the tool's own axis; needed by {@link #toolAxis} alone. */
  void point(Axis toolInFlange) {
    double[] flange = frames[FLANGE];
    for (int row = 0; row < 3; row++) {
      toolAxis[row] = toolInFlange.dot(flange[3 * row], flange[3 * row + 1], flange[3 * row + 2]);
    }
  }

  /** Position of the tool centre point along axis 0 to 2, m. */
  double tool(int axis) {
    return tool[axis];
  }

  /** Velocity of the tool centre point along axis 0 to 2, m/s. */
  double toolVelocity(int axis) {
    return toolSpeed[axis];
  }

  /** Speed of the tool centre point, m/s. */
  double toolSpeedMPerS() {
    return length(toolSpeed);
  }

  /** Angular velocity of the flange about axis 0 to 2, rad/s. */
  double turn(int axis) {
    return turn[axis];
  }

  /** Direction of the tool's own axis along axis 0 to 2, after {@link #point}. */
  double toolAxis(int axis) {
    return toolAxis[axis];
  }

  /** Position of the elbow along axis 0 to 2, m. */
  double elbow(int axis) {
    return frames[ELBOW][9 + axis];
  }

  /** Velocity of the elbow along axis 0 to 2, m/s. */
  double elbowVelocity(int axis) {
    return elbowSpeed[axis];
  }

  /** Speed of the elbow, m/s. */
  double elbowSpeedMPerS() {
    return length(elbowSpeed);
  }

  /** Position of the flange along axis 0 to 2, m. */
  double flange(int axis) {
    return frames[FLANGE][9 + axis];
  }

  /** Element of the axis of the shoulder joint along axis 0 to 2 of the base. */
  double shoulderAxis(int axis) {
    return frames[0][3 * axis + 2];
  }

  /** Position of the shoulder joint along axis 0 to 2, m. */
  double shoulder(int axis) {
    return frames[0][9 + axis];
  }

  private static double length(double[] v) {
    return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }
}
