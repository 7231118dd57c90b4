package org.pendant.models.dynamics;

/** What it takes to move a payload with the flange. */
public final class PayloadWrench {
  private PayloadWrench() {}

  /**
   * The wrench that the flange exerts on a payload: the force, and the torque about the flange's
   * origin, along the axes of the base. What the payload does to the flange is its reverse.
   * Allocates nothing.
   *
   * @param flange12 the flange in the base frame, a transformation as {@link
   *     org.pendant.models.pose.Transforms} has it
   * @param angularVelocity three numbers along the axes of the base, rad/s
   * @param felt6 acceleration of the flange's origin together with what gravity makes a resting one
   *     feel, m/s², then its angular acceleration, rad/s²; along the axes of the base
   * @param wrench6 force in N and torque in Nm, overwritten
   */
  public static void of(
      Payload payload,
      double[] flange12,
      double[] angularVelocity,
      double[] felt6,
      double[] wrench6) {
    // all along the axes of the flange: the payload's numbers are given there
    double wx = turnedX(flange12, angularVelocity, 0);
    double wy = turnedY(flange12, angularVelocity, 0);
    double wz = turnedZ(flange12, angularVelocity, 0);
    double ax = turnedX(flange12, felt6, 0);
    double ay = turnedY(flange12, felt6, 0);
    double az = turnedZ(flange12, felt6, 0);
    double ex = turnedX(flange12, felt6, 3);
    double ey = turnedY(flange12, felt6, 3);
    double ez = turnedZ(flange12, felt6, 3);
    double x = payload.cogXM();
    double y = payload.cogYM();
    double z = payload.cogZM();
    double along = wx * x + wy * y + wz * z;
    double square = wx * wx + wy * wy + wz * wz;
    double m = payload.massKg();
    double fx = m * (ax + ey * z - ez * y + wx * along - x * square);
    double fy = m * (ay + ez * x - ex * z + wy * along - y * square);
    double fz = m * (az + ex * y - ey * x + wz * along - z * square);
    double lx = payload.ixx() * wx + payload.ixy() * wy + payload.ixz() * wz;
    double ly = payload.ixy() * wx + payload.iyy() * wy + payload.iyz() * wz;
    double lz = payload.ixz() * wx + payload.iyz() * wy + payload.izz() * wz;
    double nx = payload.ixx() * ex + payload.ixy() * ey + payload.ixz() * ez + wy * lz - wz * ly;
    double ny = payload.ixy() * ex + payload.iyy() * ey + payload.iyz() * ez + wz * lx - wx * lz;
    double nz = payload.ixz() * ex + payload.iyz() * ey + payload.izz() * ez + wx * ly - wy * lx;
    toBase(flange12, fx, fy, fz, wrench6, 0);
    toBase(flange12, nx + y * fz - z * fy, ny + z * fx - x * fz, nz + x * fy - y * fx, wrench6, 3);
  }

  private static double turnedX(double[] r, double[] v, int from) {
    return r[0] * v[from] + r[3] * v[from + 1] + r[6] * v[from + 2];
  }

  private static double turnedY(double[] r, double[] v, int from) {
    return r[1] * v[from] + r[4] * v[from + 1] + r[7] * v[from + 2];
  }

  private static double turnedZ(double[] r, double[] v, int from) {
    return r[2] * v[from] + r[5] * v[from + 1] + r[8] * v[from + 2];
  }

  private static void toBase(double[] r, double x, double y, double z, double[] out, int to) {
    out[to] = r[0] * x + r[1] * y + r[2] * z;
    out[to + 1] = r[3] * x + r[4] * y + r[5] * z;
    out[to + 2] = r[6] * x + r[7] * y + r[8] * z;
  }
}
