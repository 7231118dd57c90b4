package org.pendant.models.dynamics;

import org.ejml.data.DMatrix3x3;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.JointAngles;

/**
 * Composite bodies, by which the mass matrix is found: each joint moves all links after it as one
 * body, whose first and second moments are carried from frame to frame towards the base. (R.
 * Featherstone, "Rigid Body Dynamics Algorithms", section 6.2.)
 */
final class CompositeBodies {
  private static final int N = Joints.COUNT;

  /** Sines of the twists alpha: next axes are parallel (0) or a quarter turn apart (1, -1). */
  private static final double[] SIN_ALPHA = {1, 0, 0, 1, -1, 0};

  /** From axis to axis, m; not 0 for upper arm and forearm alone. */
  private final double[] a;

  /** Along the axis, m; exactly 0 for those two. */
  private final double[] d;

  private final RigidBody[] bodies;

  /** Each body's moments about the origin of its frame: first m c, then the inertia. */
  private final double[][] moments = new double[N][];

  private final JointAngles angles;

  /** The composite body after each joint, in the frame before it: m, m c (3), inertia (6). */
  private final double[][] behind = new double[N][10];

  CompositeBodies(DhLengths dh, RigidBody[] bodies, JointAngles angles) {
    this.bodies = bodies;
    this.angles = angles;
    a = new double[] {0, dh.a2(), dh.a3(), 0, 0, 0};
    d = new double[] {dh.d1(), 0, 0, dh.d4(), dh.d5(), dh.d6()};
    for (int i = 0; i < N; i++) {
      changed(i);
    }
  }

  /** Body {@code i} has become another one. */
  void changed(int i) {
    RigidBody body = bodies[i];
    DMatrix3x3 inertia = body.about(0, 0, 0).inertia();
    moments[i] =
        new double[] {
          body.m(),
          body.m() * body.cx(),
          body.m() * body.cy(),
          body.m() * body.cz(),
          inertia.a11,
          inertia.a12,
          inertia.a13,
          inertia.a22,
          inertia.a23,
          inertia.a33
        };
  }

  /** Fills a matrix of six rows, both halves. */
  void mass(double[] q, double[] mass) {
    gather(q);
    for (int joint = 0; joint < N; joint++) {
      double[] body = behind[joint];
      mass[N * joint + joint] = body[9];
      // what accelerating the body by 1 rad/s² about z takes, carried to the joints before
      double fx = -body[2];
      double fy = body[1];
      double fz = 0;
      double nx = body[6];
      double ny = body[8];
      double nz = body[9];
      for (int i = joint - 1; i >= 0; i--) {
        double sa = SIN_ALPHA[i];
        double c = angles.cos(i);
        double s = angles.sin(i);
        double t = fy;
        double u = ny;
        if (sa != 0) {
          t = -sa * fz;
          fz = sa * fy;
          u = -sa * nz;
          nz = sa * ny;
        }
        fy = s * fx + c * t;
        fx = c * fx - s * t;
        ny = s * nx + c * u;
        nx = c * nx - s * u;
        if (a[i] == 0) {
          ny += d[i] * fx;
          nx -= d[i] * fy;
        } else {
          double px = a[i] * c;
          double py = a[i] * s;
          nz = nz + px * fy - py * fx;
          ny -= px * fz;
          nx += py * fz;
        }
        mass[N * joint + i] = nz;
        mass[N * i + joint] = nz;
      }
    }
  }

  /** Work that lifted the arm against an acceleration that it feels, J. */
  double potentialEnergyJ(double[] q, double x, double y, double z) {
    gather(q);
    double[] all = behind[0];
    return x * all[1] + y * all[2] + z * all[3];
  }

  /**
   * At a posture whose cosines and sines are known: what is behind a joint is gathered as for the
   * mass matrix, without the inertia, and what moves carried along with it.
   */
  void linearMomentum(JointAngles angles, double[] qd, double[] momentum) {
    double m = 0;
    double hx = 0;
    double hy = 0;
    double hz = 0;
    double x = 0;
    double y = 0;
    double z = 0;
    for (int i = N - 1; i >= 0; i--) {
      double[] own = moments[i];
      m += own[0];
      hx += own[1];
      hy += own[2];
      hz += own[3];
      double sa = SIN_ALPHA[i];
      if (sa != 0) {
        double t = hy;
        hy = -sa * hz;
        hz = sa * t;
        t = y;
        y = -sa * z;
        z = sa * t;
      }
      double c = angles.cos(i);
      double s = angles.sin(i);
      double t = c * hx - s * hy;
      hy = s * hx + c * hy;
      hx = t;
      if (a[i] == 0) {
        hz += m * d[i];
      } else {
        hy += m * (a[i] * s);
        hx += m * (a[i] * c);
      }
      t = c * x - s * y - qd[i] * hy;
      y = s * x + c * y + qd[i] * hx;
      x = t;
    }
    momentum[0] = x;
    momentum[1] = y;
    momentum[2] = z;
  }

  /** Each joint turns the mass after it, gathered from the last link on, about its axis. */
  void linearMomentum(double[][] frames, double[] qd, double[] momentum) {
    double m = 0;
    double hx = 0;
    double hy = 0;
    double hz = 0;
    double x = 0;
    double y = 0;
    double z = 0;
    for (int i = N - 1; i >= 0; i--) {
      double[] f = frames[i];
      double[] own = moments[i];
      m += own[0];
      hx += f[0] * own[1] + f[1] * own[2] + f[2] * own[3] + own[0] * f[9];
      hy += f[3] * own[1] + f[4] * own[2] + f[5] * own[3] + own[0] * f[10];
      hz += f[6] * own[1] + f[7] * own[2] + f[8] * own[3] + own[0] * f[11];
      if (i == 0) {
        x -= qd[0] * hy;
        y += qd[0] * hx;
      } else {
        double[] axis = frames[i - 1];
        double wx = qd[i] * axis[2];
        double wy = qd[i] * axis[5];
        double wz = qd[i] * axis[8];
        double rx = hx - m * axis[9];
        double ry = hy - m * axis[10];
        double rz = hz - m * axis[11];
        x += wy * rz - wz * ry;
        y += wz * rx - wx * rz;
        z += wx * ry - wy * rx;
      }
    }
    momentum[0] = x;
    momentum[1] = y;
    momentum[2] = z;
  }

  private void gather(double[] q) {
    angles.at(q);
    for (int i = N - 1; i >= 0; i--) {
      double c = angles.cos(i);
      double s = angles.sin(i);
      double[] own = moments[i];
      double m = own[0];
      double hx = own[1];
      double hy = own[2];
      double hz = own[3];
      double xx = own[4];
      double xy = own[5];
      double xz = own[6];
      double yy = own[7];
      double yz = own[8];
      double zz = own[9];
      if (i < N - 1) {
        double[] next = behind[i + 1];
        m += next[0];
        hx += next[1];
        hy += next[2];
        hz += next[3];
        xx += next[4];
        xy += next[5];
        xz += next[6];
        yy += next[7];
        yz += next[8];
        zz += next[9];
      }
      // turned by alpha about x: by nothing or a quarter turn
      double sa = SIN_ALPHA[i];
      if (sa != 0) {
        double t = hy;
        hy = -sa * hz;
        hz = sa * t;
        t = xy;
        xy = -sa * xz;
        xz = sa * t;
        t = yy;
        yy = zz;
        zz = t;
        yz = -yz;
      }
      // turned by q about z
      double t = c * hx - s * hy;
      hy = s * hx + c * hy;
      hx = t;
      t = c * xz - s * yz;
      yz = s * xz + c * yz;
      xz = t;
      double cc = c * c;
      double cs = c * s;
      double ss = s * s;
      t = cc * xx - 2 * cs * xy + ss * yy;
      double turnedXy = cs * (xx - yy) + (cc - ss) * xy;
      yy = ss * xx + 2 * cs * xy + cc * yy;
      xx = t;
      xy = turnedXy;
      // about the origin of the frame before
      double[] out = behind[i];
      out[0] = m;
      if (a[i] == 0) {
        double pz = d[i];
        double toZ = pz * (2 * hz + m * pz);
        out[1] = hx;
        out[2] = hy;
        out[3] = hz + m * pz;
        out[4] = xx + toZ;
        out[5] = xy;
        out[6] = xz - hx * pz;
        out[7] = yy + toZ;
        out[8] = yz - hy * pz;
        out[9] = zz;
      } else {
        double px = a[i] * c;
        double py = a[i] * s;
        double ox = 2 * hx + m * px;
        double oy = 2 * hy + m * py;
        out[1] = hx + m * px;
        out[2] = hy + m * py;
        out[3] = hz;
        out[4] = xx + py * oy;
        out[5] = xy - hx * py - hy * px - m * px * py;
        out[6] = xz - hz * px;
        out[7] = yy + px * ox;
        out[8] = yz - hz * py;
        out[9] = zz + px * ox + py * oy;
      }
    }
  }
}
