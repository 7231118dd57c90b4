package org.pendant.controller.safety;

import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.JointAngles;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Arm points: where tool and elbow are and how they move, for one state of the joints; all in the
 * base frame. The elbow is the origin of Denavit-Hartenberg frame 2, the end of the upper arm.
 * Mutable, and allocates nothing after it was made.
 */
final class ArmPoints {
  private static final int FLANGE = Joints.COUNT - 1;
  private static final int ELBOW = 1;

  private final ForwardKinematics forward;
  private final double[][] ownFrames = new double[Joints.COUNT][Transforms.SIZE];
  private double[][] frames = ownFrames;
  private final double[] tool = new double[3];
  private final double[] toolSpeed = new double[3];
  private final double[] turn = new double[3];
  private final double[] elbowSpeed = new double[3];
  private final double[] toolAxis = new double[3];

  ArmPoints(ArmDescription arm) {
    forward = new ForwardKinematics(arm);
  }

  /**
   * Looks at a state.
   *
   * @param q six joint positions, rad
   * @param qd six joint speeds, rad/s
   */
  void at(double[] q, double[] qd, Pose tcpInFlange) {
    forward.frames(q, ownFrames);
    at(ownFrames, qd, tcpInFlange);
  }

  /**
   * As {@link #at(double[], double[], Pose)}.
   *
   * @param angles cosines and sines of {@code q}
   */
  void at(double[] q, JointAngles angles, double[] qd, Pose tcpInFlange) {
    forward.frames(q, angles, ownFrames);
    at(ownFrames, qd, tcpInFlange);
  }

  /**
   * Looks at a state of which the frames of the links are known.
   *
   * @param linkFrames Denavit-Hartenberg frames 1 to 6 in the base frame; looked at again for what
   *     is asked afterwards
   * @param qd six joint speeds, rad/s
   */
  void at(double[][] linkFrames, double[] qd, Pose tcpInFlange) {
    frames = linkFrames;
    double[] flange = frames[FLANGE];
    for (int row = 0; row < 3; row++) {
      tool[row] =
          flange[9 + row]
              + flange[3 * row] * tcpInFlange.x()
              + flange[3 * row + 1] * tcpInFlange.y()
              + flange[3 * row + 2] * tcpInFlange.z();
    }
    moveTool(qd);
    moveElbow(qd[0], qd[1]);
  }

  /** Adds what each joint with axis z through p does at its speed: z x (tool - p), and z. */
  private void moveTool(double[] qd) {
    double turnX = 0;
    double turnY = 0;
    double turnZ = qd[0];
    double speedX = -qd[0] * tool[1];
    double speedY = qd[0] * tool[0];
    double speedZ = 0;
    for (int i = 1; i < Joints.COUNT; i++) {
      double[] f = frames[i - 1];
      double wx = f[2] * qd[i];
      double wy = f[5] * qd[i];
      double wz = f[8] * qd[i];
      turnX += wx;
      turnY += wy;
      turnZ += wz;
      double rx = tool[0] - f[9];
      double ry = tool[1] - f[10];
      double rz = tool[2] - f[11];
      speedX += wy * rz - wz * ry;
      speedY += wz * rx - wx * rz;
      speedZ += wx * ry - wy * rx;
    }
    turn[0] = turnX;
    turn[1] = turnY;
    turn[2] = turnZ;
    toolSpeed[0] = speedX;
    toolSpeed[1] = speedY;
    toolSpeed[2] = speedZ;
  }

  /** The first two joints alone move the elbow. */
  private void moveElbow(double baseSpeed, double shoulderSpeed) {
    double[] f = frames[0];
    double[] elbow = frames[ELBOW];
    double wx = f[2] * shoulderSpeed;
    double wy = f[5] * shoulderSpeed;
    double wz = f[8] * shoulderSpeed;
    double rx = elbow[9] - f[9];
    double ry = elbow[10] - f[10];
    double rz = elbow[11] - f[11];
    elbowSpeed[0] = -baseSpeed * elbow[10] + (wy * rz - wz * ry);
    elbowSpeed[1] = baseSpeed * elbow[9] + (wz * rx - wx * rz);
    elbowSpeed[2] = wx * ry - wy * rx;
  }

  /** Denavit-Hartenberg frames 1 to 6 in the base frame; only to be read. */
  double[][] frames() {
    return frames;
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
