package org.pendant.models.dynamics;

/**
 * Flange motion: how the flange moves, along its own axes, as the latest {@link
 * ArmDynamics#inverse} has found it: what an accelerometer in it reads, and what a load on it
 * weighs. Only for the frame loop that owns the dynamics; its numbers change with every call.
 */
public final class FlangeMotion {
  private double wx;
  private double wy;
  private double wz;
  private double ex;
  private double ey;
  private double ez;
  private double px;
  private double py;
  private double pz;

  FlangeMotion() {}

  void setAngular(double wx, double wy, double wz, double ex, double ey, double ez) {
    this.wx = wx;
    this.wy = wy;
    this.wz = wz;
    this.ex = ex;
    this.ey = ey;
    this.ez = ez;
  }

  void setFelt(double px, double py, double pz) {
    this.px = px;
    this.py = py;
    this.pz = pz;
  }

  /**
   * What the flange's origin feels along one of the flange's axes: its acceleration, and that of
   * gravity and base. At rest an axis that points up reads 9.82 m/s².
   *
   * @param axis 0 to 2
   */
  public double feltMPerS2(int axis) {
    return switch (axis) {
      case 0 -> px;
      case 1 -> py;
      case 2 -> pz;
      default -> throw new IllegalArgumentException("axis is " + axis + ", must be 0 to 2");
    };
  }

  /**
   * The wrench with which a payload hangs on the flange by its weight and inertia: the force on the
   * flange and the torque about its origin, along its axes. Allocates nothing.
   *
   * @param wrench six numbers, N and Nm, overwritten
   */
  public void loadOf(Payload payload, double[] wrench) {
    double x = payload.cogXM();
    double y = payload.cogYM();
    double z = payload.cogZM();
    double m = payload.massKg();
    double fx = m * (px + ey * z - ez * y + wy * (wx * y - wy * x) - wz * (wz * x - wx * z));
    double fy = m * (py + ez * x - ex * z + wz * (wy * z - wz * y) - wx * (wx * y - wy * x));
    double fz = m * (pz + ex * y - ey * x + wx * (wz * x - wx * z) - wy * (wy * z - wz * y));
    double lx = payload.ixx() * wx + payload.ixy() * wy + payload.ixz() * wz;
    double ly = payload.ixy() * wx + payload.iyy() * wy + payload.iyz() * wz;
    double lz = payload.ixz() * wx + payload.iyz() * wy + payload.izz() * wz;
    double nx = payload.ixx() * ex + payload.ixy() * ey + payload.ixz() * ez + wy * lz - wz * ly;
    double ny = payload.ixy() * ex + payload.iyy() * ey + payload.iyz() * ez + wz * lx - wx * lz;
    double nz = payload.ixz() * ex + payload.iyz() * ey + payload.izz() * ez + wx * ly - wy * lx;
    wrench[0] = -fx;
    wrench[1] = -fy;
    wrench[2] = -fz;
    wrench[3] = -(nx + y * fz - z * fy);
    wrench[4] = -(ny + z * fx - x * fz);
    wrench[5] = -(nz + x * fy - y * fx);
  }
}
