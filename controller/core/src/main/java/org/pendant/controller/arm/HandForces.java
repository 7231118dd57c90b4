package org.pendant.controller.arm;

import org.pendant.controller.world.HandGrip;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Transforms;

/**
 * Joint torques of a hand that holds the arm at a point. Joints beyond the link that it holds get
 * none; each joint before feels the force times its lever: column i of the Jacobian of the gripped
 * point is {@code z x (p - o)} for an axis z through o. (B. Siciliano et al., "Robotics: Modelling,
 * Planning and Control", equation 3.30.)
 */
final class HandForces {
  /** Share of a motor's largest torque that is left when it holds the arm's weight; our choice. */
  private static final double RESISTIBLE_SHARE = 0.5;

  private static final int N = Joints.COUNT;

  private final HandGrip grip;
  private final ForwardKinematics forward;
  private final double[][] frames = new double[N][Transforms.SIZE];
  private final double[] levers = new double[3 * N];
  private final double[] point3 = new double[3];
  private final double[] velocity3 = new double[3];
  private final double[] force3 = new double[3];
  private final double[] resistibleNm = new double[N];

  HandForces(HandGrip grip, ArmDescription arm, ForwardKinematics forward) {
    this.grip = grip;
    this.forward = forward;
    for (int i = 0; i < N; i++) {
      resistibleNm[i] = RESISTIBLE_SHARE * arm.joints().get(i).maxTorqueNm();
    }
  }

  /**
   * Adds the load of the hand, if there is one.
   *
   * @param q joint positions, rad
   * @param qd joint speeds, rad/s
   * @param torqueNm joint torques, added to, Nm
   * @param wrench6 load at the flange's origin along the base's axes, added to when the hand holds
   *     the last link, which the flange is part of
   */
  void add(double[] q, double[] qd, double[] torqueNm, double[] wrench6) {
    if (!grip.holds()) {
      return;
    }
    forward.frames(q, frames);
    int link = grip.link();
    double[] held = frames[link];
    for (int row = 0; row < 3; row++) {
      point3[row] =
          held[9 + row]
              + held[3 * row] * grip.pointInLinkM(0)
              + held[3 * row + 1] * grip.pointInLinkM(1)
              + held[3 * row + 2] * grip.pointInLinkM(2);
      velocity3[row] = 0;
    }
    lever(0, 0, 0, 1, 0, 0, 0);
    for (int i = 1; i <= link; i++) {
      double[] before = frames[i - 1];
      lever(i, before[2], before[5], before[8], before[9], before[10], before[11]);
    }
    for (int i = 0; i <= link; i++) {
      for (int row = 0; row < 3; row++) {
        velocity3[row] += levers[3 * i + row] * qd[i];
      }
    }
    grip.force(point3, velocity3, force3);
    if (grip.pulls()) {
      soften(link);
    }
    for (int i = 0; i <= link; i++) {
      torqueNm[i] += torqueNm(i);
    }
    if (link == N - 1) {
      addAtFlange(wrench6);
    }
  }

  private double torqueNm(int i) {
    return levers[3 * i] * force3[0]
        + levers[3 * i + 1] * force3[1]
        + levers[3 * i + 2] * force3[2];
  }

  /** Pulls no harder than the motors can resist: a small arm is not torn about. */
  private void soften(int link) {
    double share = 1;
    for (int i = 0; i <= link; i++) {
      share = Math.min(share, resistibleNm[i] / Math.abs(torqueNm(i)));
    }
    for (int row = 0; row < 3; row++) {
      force3[row] *= share;
    }
  }

  /**
   * Writes the velocity of the gripped point when joint i alone turns by 1 rad/s about its axis z
   * through o.
   */
  private void lever(int i, double zx, double zy, double zz, double ox, double oy, double oz) {
    double x = point3[0] - ox;
    double y = point3[1] - oy;
    double z = point3[2] - oz;
    levers[3 * i] = zy * z - zz * y;
    levers[3 * i + 1] = zz * x - zx * z;
    levers[3 * i + 2] = zx * y - zy * x;
  }

  private void addAtFlange(double[] wrench6) {
    double[] flange = frames[N - 1];
    double x = point3[0] - flange[9];
    double y = point3[1] - flange[10];
    double z = point3[2] - flange[11];
    wrench6[0] += force3[0];
    wrench6[1] += force3[1];
    wrench6[2] += force3[2];
    wrench6[3] += y * force3[2] - z * force3[1];
    wrench6[4] += z * force3[0] - x * force3[2];
    wrench6[5] += x * force3[1] - y * force3[0];
  }
}
