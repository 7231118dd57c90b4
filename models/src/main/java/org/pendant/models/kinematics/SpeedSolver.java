package org.pendant.models.kinematics;

import org.pendant.models.arm.Joints;

/**
 * Six linear equations for six joint speeds: exactly by elimination, or damped by least squares (B.
 * Siciliano et al., "Robotics: Modelling, Planning and Control", section 3.5.2). Keeps its scratch
 * space, so it allocates nothing.
 */
final class SpeedSolver {
  /**
   * Pivot below which the arm counts as singular. Entries are of the order of 1 (m and rad), so the
   * speeds found just above it would be millions of times the twist.
   */
  private static final double SINGULAR_PIVOT = 1e-9;

  private static final int N = Joints.COUNT;

  private final double[] work = new double[N * N];
  private final double[] side = new double[N];

  /** Gauss elimination with row pivoting; see {@link Jacobian#solve}. */
  boolean solve(double[] jacobian, double[] twist, double[] qd) {
    System.arraycopy(jacobian, 0, work, 0, work.length);
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

  /** The normal equations, by their Cholesky factor; see {@link Jacobian#solveDamped}. */
  void solveDamped(double[] jacobian, double[] twist, double damping, double[] qd) {
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
}
