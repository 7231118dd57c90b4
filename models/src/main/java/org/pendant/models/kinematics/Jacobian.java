package org.pendant.models.kinematics;

import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * The geometric Jacobian: joint speeds to the twist of the TCP (manual 16.17), and back.
 *
 * <p>A twist is six numbers, the velocity of the TCP's origin in m/s, then the angular velocity in
 * rad/s, both along the axes of the base frame. Column i of the Jacobian is what joint i alone
 * gives at 1 rad/s: {@code (z x (p_tcp - p), z)} for an axis z through p. (B. Siciliano et al.,
 * "Robotics: Modelling, Planning and Control", equation 3.30; the damped inverse is its section
 * 3.5.2.)
 *
 * <p>A matrix is a {@code double[36]}, its rows one after another. Methods write into their last
 * parameter and allocate nothing. An object keeps scratch space between calls: it must not be used
 * by two threads at once.
 */
public final class Jacobian {
  /** Numbers in a Jacobian. */
  public static final int SIZE = Joints.COUNT * Joints.COUNT;

  /**
   * Pivot below which the arm counts as singular. Entries are of the order of 1 (m and rad), so the
   * speeds found just above it would be millions of times the twist.
   */
  private static final double SINGULAR_PIVOT = 1e-9;

  private static final int N = Joints.COUNT;

  private final ForwardKinematics forward;
  private final double[][] frames = new double[N][Transforms.SIZE];
  private final double[] work = new double[SIZE];
  private final double[] side = new double[N];

  /** The Jacobian of an arm with these lengths. */
  public Jacobian(DhLengths dh) {
    forward = new ForwardKinematics(dh);
  }

  /**
   * The Jacobian at joint positions {@code q}.
   *
   * @param q six joint positions, rad
   * @param tcpInFlange the TCP offset; only its position matters
   * @param jacobian 36 numbers, overwritten
   */
  public void at(double[] q, Pose tcpInFlange, double[] jacobian) {
    forward.frames(q, frames);
    double[] flange = frames[N - 1];
    double px = flange[9] + turned(flange, 0, tcpInFlange);
    double py = flange[10] + turned(flange, 3, tcpInFlange);
    double pz = flange[11] + turned(flange, 6, tcpInFlange);
    column(0, 0, 1, px, py, pz, 0, jacobian);
    for (int i = 1; i < N; i++) {
      double[] axis = frames[i - 1];
      column(axis[2], axis[5], axis[8], px - axis[9], py - axis[10], pz - axis[11], i, jacobian);
    }
  }

  /**
   * The twist that joint speeds give.
   *
   * @param jacobian 36 numbers
   * @param qd six joint speeds, rad/s
   * @param twist six numbers, overwritten; must not be {@code qd}
   */
  public static void twist(double[] jacobian, double[] qd, double[] twist) {
    for (int row = 0; row < N; row++) {
      double sum = 0;
      for (int i = 0; i < N; i++) {
        sum += jacobian[N * row + i] * qd[i];
      }
      twist[row] = sum;
    }
  }

  /**
   * The joint speeds that give a twist, by elimination with row pivoting.
   *
   * @param jacobian 36 numbers
   * @param twist six numbers
   * @param qd six joint speeds in rad/s, overwritten
   * @return false if the arm is singular; {@code qd} is then undefined
   */
  public boolean solve(double[] jacobian, double[] twist, double[] qd) {
    System.arraycopy(jacobian, 0, work, 0, SIZE);
    System.arraycopy(twist, 0, side, 0, N);
    for (int step = 0; step < N; step++) {
      swapRows(step, pivotRow(step));
      double pivot = work[N * step + step];
      if (!(Math.abs(pivot) >= SINGULAR_PIVOT)) {
        return false;
      }
      for (int row = step + 1; row < N; row++) {
        double factor = work[N * row + step] / pivot;
        for (int i = step + 1; i < N; i++) {
          work[N * row + i] -= factor * work[N * step + i];
        }
        side[row] -= factor * side[step];
      }
    }
    for (int row = N - 1; row >= 0; row--) {
      double sum = side[row];
      for (int i = row + 1; i < N; i++) {
        sum -= work[N * row + i] * qd[i];
      }
      qd[row] = sum / work[N * row + row];
    }
    return true;
  }

  /**
   * The joint speeds that come nearest to a twist while staying moderate: the least {@code |J qd -
   * twist|^2 + damping^2 |qd|^2}. Unlike {@link #solve} it passes through singularities; away from
   * them it differs from it by about the square of damping over the smallest singular value.
   *
   * @param jacobian 36 numbers
   * @param twist six numbers
   * @param damping above 0; 0.01 to 0.1 is usual
   * @param qd six joint speeds in rad/s, overwritten
   * @throws IllegalArgumentException if damping is not above 0
   */
  public void solveDamped(double[] jacobian, double[] twist, double damping, double[] qd) {
    if (!(damping > 0)) {
      throw new IllegalArgumentException("jacobian: damping is " + damping + ", must be above 0");
    }
    for (int row = 0; row < N; row++) {
      for (int i = 0; i <= row; i++) {
        double sum = row == i ? damping * damping : 0;
        for (int k = 0; k < N; k++) {
          sum += jacobian[N * k + row] * jacobian[N * k + i];
        }
        work[N * row + i] = sum;
      }
      double sum = 0;
      for (int k = 0; k < N; k++) {
        sum += jacobian[N * k + row] * twist[k];
      }
      side[row] = sum;
    }
    factorise();
    for (int row = 0; row < N; row++) {
      double sum = side[row];
      for (int i = 0; i < row; i++) {
        sum -= work[N * row + i] * qd[i];
      }
      qd[row] = sum / work[N * row + row];
    }
    for (int row = N - 1; row >= 0; row--) {
      double sum = qd[row];
      for (int i = row + 1; i < N; i++) {
        sum -= work[N * i + row] * qd[i];
      }
      qd[row] = sum / work[N * row + row];
    }
  }

  /** Cholesky factor of the lower half of {@code work}, in place; damping makes it exist. */
  private void factorise() {
    for (int row = 0; row < N; row++) {
      for (int i = 0; i <= row; i++) {
        double sum = work[N * row + i];
        for (int k = 0; k < i; k++) {
          sum -= work[N * row + k] * work[N * i + k];
        }
        work[N * row + i] = row == i ? Math.sqrt(sum) : sum / work[N * i + i];
      }
    }
  }

  private int pivotRow(int step) {
    int best = step;
    for (int row = step + 1; row < N; row++) {
      if (Math.abs(work[N * row + step]) > Math.abs(work[N * best + step])) {
        best = row;
      }
    }
    return best;
  }

  private void swapRows(int a, int b) {
    if (a == b) {
      return;
    }
    for (int i = 0; i < N; i++) {
      double kept = work[N * a + i];
      work[N * a + i] = work[N * b + i];
      work[N * b + i] = kept;
    }
    double kept = side[a];
    side[a] = side[b];
    side[b] = kept;
  }

  private static double turned(double[] transform, int row, Pose offset) {
    return transform[row] * offset.x()
        + transform[row + 1] * offset.y()
        + transform[row + 2] * offset.z();
  }

  /** Writes column i: axis z, and the arm (x, y, z) from the axis to the TCP. */
  private static void column(
      double zx, double zy, double zz, double x, double y, double z, int i, double[] jacobian) {
    jacobian[i] = zy * z - zz * y;
    jacobian[N + i] = zz * x - zx * z;
    jacobian[2 * N + i] = zx * y - zy * x;
    jacobian[3 * N + i] = zx;
    jacobian[4 * N + i] = zy;
    jacobian[5 * N + i] = zz;
  }
}
