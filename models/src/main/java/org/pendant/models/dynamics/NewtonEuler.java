package org.pendant.models.dynamics;

import org.ejml.data.DMatrix3x3;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.JointAngles;

/**
 * The recursive Newton-Euler method in the links' Denavit-Hartenberg frames: speeds and
 * accelerations outwards, forces and torques back. (B. Siciliano et al., "Robotics: Modelling,
 * Planning and Control", equations 7.107 to 7.114.)
 */
final class NewtonEuler {
  private static final int N = Joints.COUNT;

  /** Sines of the twists alpha: next axes are parallel (0) or a quarter turn apart (1, -1). */
  private static final double[] SIN_ALPHA = {1, 0, 0, 1, -1, 0};

  private final RigidBody[] bodies;

  /**
   * From the origin of the frame before to a link's own, along its own axes, m: across parallel
   * axes or along them, and along y alone where they are a quarter turn apart.
   */
  private final double[] rx = new double[N];

  private final double[] ry = new double[N];
  private final double[] rz = new double[N];

  private final JointAngles angles;

  /** Force at and torque about each centre of mass, along the link's axes. */
  private final double[] fx = new double[N];

  private final double[] fy = new double[N];
  private final double[] fz = new double[N];
  private final double[] nx = new double[N];
  private final double[] ny = new double[N];
  private final double[] nz = new double[N];

  /** How the last link moves, as of the latest call. */
  final FlangeMotion flange = new FlangeMotion();

  private double baseX;
  private double baseY;
  private double baseZ;

  NewtonEuler(DhLengths dh, RigidBody[] bodies, JointAngles angles) {
    this.bodies = bodies;
    this.angles = angles;
    double[] a = {0, dh.a2(), dh.a3(), 0, 0, 0};
    double[] d = {dh.d1(), 0, 0, dh.d4(), dh.d5(), dh.d6()};
    for (int i = 0; i < N; i++) {
      rx[i] = a[i];
      ry[i] = d[i] * SIN_ALPHA[i];
      rz[i] = SIN_ALPHA[i] == 0 ? d[i] : 0;
    }
  }

  void setBase(double x, double y, double z) {
    baseX = x;
    baseY = y;
    baseZ = z;
  }

  void torques(double[] q, double[] qd, double[] qdd, boolean withBase, double[] torque) {
    outwards(q, qd, qdd, withBase, true);
    back(torque);
  }

  /** Only how the flange moves, as {@link #torques} does with the acceleration of the base. */
  void moveFlange(double[] q, double[] qd, double[] qdd) {
    outwards(q, qd, qdd, true, false);
  }

  private void outwards(
      double[] q, double[] qd, double[] qdd, boolean withBase, boolean withForces) {
    angles.at(q);
    double wx = 0;
    double wy = 0;
    double wz = 0;
    double ex = 0;
    double ey = 0;
    double ez = 0;
    double px = withBase ? baseX : 0;
    double py = withBase ? baseY : 0;
    double pz = withBase ? baseZ : 0;
    for (int i = 0; i < N; i++) {
      double c = angles.cos(i);
      double s = angles.sin(i);
      double sa = SIN_ALPHA[i];
      // the angular acceleration gets qdd z + qd w x z before the frame is turned
      double ax = ex + qd[i] * wy;
      double ay = ey - qd[i] * wx;
      double az = ez + qdd[i];
      double bz = wz + qd[i];
      // R transposed times a vector: turned back by q about z, then by alpha about x
      double t = c * wy - s * wx;
      wx = c * wx + s * wy;
      double u = c * ay - s * ax;
      ex = c * ax + s * ay;
      double v = c * py - s * px;
      px = c * px + s * py;
      if (sa == 0) {
        wy = t;
        wz = bz;
        ey = u;
        ez = az;
        py = v;
      } else {
        wy = sa * bz;
        wz = -sa * t;
        ey = sa * az;
        ez = -sa * u;
        py = sa * pz;
        pz = -sa * v;
      }

      double xx = wx * wx;
      double yy = wy * wy;
      double zz = wz * wz;
      double xy = wx * wy;
      double xz = wx * wz;
      double yz = wy * wz;
      if (sa == 0) {
        double x = rx[i];
        double z = rz[i];
        px += (xz + ey) * z - (yy + zz) * x;
        py += (xy + ez) * x + (yz - ex) * z;
        pz += (xz - ey) * x - (xx + yy) * z;
      } else {
        double y = ry[i];
        px += (xy - ez) * y;
        py -= (xx + zz) * y;
        pz += (yz + ex) * y;
      }

      if (!withForces) {
        continue;
      }
      RigidBody body = bodies[i];
      double x = body.cx();
      double y = body.cy();
      double z = body.cz();
      fx[i] = body.m() * (px + (xy - ez) * y + (xz + ey) * z - (yy + zz) * x);
      fy[i] = body.m() * (py + (xy + ez) * x + (yz - ex) * z - (xx + zz) * y);
      fz[i] = body.m() * (pz + (xz - ey) * x + (yz + ex) * y - (xx + yy) * z);
      DMatrix3x3 inertia = body.inertia();
      double hx = inertia.a11 * wx + inertia.a12 * wy + inertia.a13 * wz;
      double hy = inertia.a21 * wx + inertia.a22 * wy + inertia.a23 * wz;
      double hz = inertia.a31 * wx + inertia.a32 * wy + inertia.a33 * wz;
      double momentX = inertia.a11 * ex + inertia.a12 * ey + inertia.a13 * ez;
      double momentY = inertia.a21 * ex + inertia.a22 * ey + inertia.a23 * ez;
      double momentZ = inertia.a31 * ex + inertia.a32 * ey + inertia.a33 * ez;
      nx[i] = momentX + wy * hz - wz * hy;
      ny[i] = momentY + wz * hx - wx * hz;
      nz[i] = momentZ + wx * hy - wy * hx;
    }
    flange.setAngular(wx, wy, wz, ex, ey, ez);
    flange.setFelt(px, py, pz);
  }

  private void back(double[] torque) {
    // force and torque that the next link asks for, along the axes of this one, at its origin
    double gx = 0;
    double gy = 0;
    double gz = 0;
    double hx = 0;
    double hy = 0;
    double hz = 0;
    for (int i = N - 1; i >= 0; i--) {
      RigidBody body = bodies[i];
      double x = rx[i] + body.cx();
      double y = ry[i] + body.cy();
      double z = rz[i] + body.cz();
      // about the origin of the frame before
      double ux = hx + nx[i] + y * fz[i] - z * fy[i];
      double uy = hy + ny[i] + z * fx[i] - x * fz[i];
      double uz = hz + nz[i] + x * fy[i] - y * fx[i];
      double sa = SIN_ALPHA[i];
      if (sa == 0) {
        ux -= rz[i] * gy;
        uy += rz[i] * gx - rx[i] * gz;
        uz += rx[i] * gy;
      } else {
        ux += ry[i] * gz;
        uz -= ry[i] * gx;
      }
      gx += fx[i];
      gy += fy[i];
      gz += fz[i];
      // turned by alpha about x, then by q about z
      double t = gy;
      double v = uy;
      if (sa != 0) {
        t = -sa * gz;
        gz = sa * gy;
        v = -sa * uz;
        uz = sa * uy;
      }
      torque[i] = uz;
      if (i > 0) {
        double c = angles.cos(i);
        double s = angles.sin(i);
        gy = s * gx + c * t;
        gx = c * gx - s * t;
        hz = uz;
        hy = s * ux + c * v;
        hx = c * ux - s * v;
      }
    }
  }
}
