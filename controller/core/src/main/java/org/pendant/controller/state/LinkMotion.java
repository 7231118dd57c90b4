package org.pendant.controller.state;

import org.pendant.controller.world.Vector3;
import org.pendant.models.pose.Pose;

/**
 * Link motion: how a point of the arm moves, followed from the base outwards: at each joint the
 * rotation changes, and along each link the point. (J. J. Craig, "Introduction to Robotics",
 * equations 6.31 to 6.36.) Everything is along the axes of the base.
 */
final class LinkMotion {
  /** Place, velocity and acceleration of the point, m, m/s, m/s². */
  final double[] p = new double[3];

  final double[] v = new double[3];
  final double[] a = new double[3];

  /** Angular velocity and acceleration of the link that carries it, rad/s and rad/s². */
  final double[] w = new double[3];

  final double[] alpha = new double[3];

  private final double[] cross = new double[3];

  /** Goes over to the link that joint {@code i} moves; the point is on the joint's axis. */
  void turn(int i, double[][] frames, double qd, double qdd) {
    double zx = i == 0 ? 0 : frames[i - 1][2];
    double zy = i == 0 ? 0 : frames[i - 1][5];
    double zz = i == 0 ? 1 : frames[i - 1][8];
    cross(w, zx * qd, zy * qd, zz * qd, cross);
    add(alpha, zx * qdd, zy * qdd, zz * qdd);
    add(alpha, cross[0], cross[1], cross[2]);
    add(w, zx * qd, zy * qd, zz * qd);
  }

  /** Goes to another point of the same link, by its place in the base frame, m. */
  void goTo(double x, double y, double z) {
    double dx = x - p[0];
    double dy = y - p[1];
    double dz = z - p[2];
    cross(alpha, dx, dy, dz, cross);
    add(a, cross[0], cross[1], cross[2]);
    cross(w, dx, dy, dz, cross);
    double sx = cross[0];
    double sy = cross[1];
    double sz = cross[2];
    add(v, sx, sy, sz);
    cross(w, sx, sy, sz, cross);
    add(a, cross[0], cross[1], cross[2]);
    p[0] = x;
    p[1] = y;
    p[2] = z;
  }

  /** The same, by its place in the frame of the link, m. */
  void goTo(double[] frame12, double x, double y, double z) {
    goTo(
        frame12[9] + frame12[0] * x + frame12[1] * y + frame12[2] * z,
        frame12[10] + frame12[3] * x + frame12[4] * y + frame12[5] * z,
        frame12[11] + frame12[6] * x + frame12[7] * y + frame12[8] * z);
  }

  Vector3 place() {
    return new Vector3(p[0], p[1], p[2]);
  }

  Vector3 velocity() {
    return new Vector3(v[0], v[1], v[2]);
  }

  /** Velocity of the point and angular velocity. */
  Pose twist() {
    return new Pose(v[0], v[1], v[2], w[0], w[1], w[2]);
  }

  /** Acceleration of the point and angular acceleration. */
  Pose acceleration() {
    return new Pose(a[0], a[1], a[2], alpha[0], alpha[1], alpha[2]);
  }

  static void cross(double[] u, double x, double y, double z, double[] product) {
    product[0] = u[1] * z - u[2] * y;
    product[1] = u[2] * x - u[0] * z;
    product[2] = u[0] * y - u[1] * x;
  }

  private static void add(double[] sum, double x, double y, double z) {
    sum[0] += x;
    sum[1] += y;
    sum[2] += z;
  }
}
