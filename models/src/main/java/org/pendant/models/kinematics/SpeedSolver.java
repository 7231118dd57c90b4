package org.pendant.models.kinematics;

import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.decomposition.TriangularSolver_DDRM;
import org.ejml.dense.row.misc.UnrolledCholesky_DDRM;
import org.ejml.dense.row.mult.MatrixMatrixMult_DDRM;
import org.ejml.dense.row.mult.MatrixVectorMult_DDRM;
import org.pendant.models.arm.Joints;

/**
 * Joint speed solver: six linear equations for six joint speeds: exactly by elimination, or damped
 * by least squares (B. Siciliano et al., "Robotics: Modelling, Planning and Control", section
 * 3.5.2). Keeps its scratch space, so it allocates nothing.
 */
final class SpeedSolver {
  /**
   * Pivot below which the arm counts as singular. Entries are of the order of 1 (m and rad), so the
   * speeds found just above it would be millions of times the twist.
   */
  private static final double SINGULAR_PIVOT = 1e-9;

  private static final int N = Joints.COUNT;

  /** Views of the arrays that are handed over, for EJML; their own content counts for nothing. */
  private final DMatrixRMaj matrix = new DMatrixRMaj(N, N);

  private final DMatrixRMaj side = new DMatrixRMaj(N, 1);
  private final DMatrixRMaj speeds = new DMatrixRMaj(N, 1);

  private final DMatrixRMaj normal = new DMatrixRMaj(N, N);
  private final DMatrixRMaj factor = new DMatrixRMaj(N, N);

  /** The matrix in rows, of which elimination leaves the upper half; what is below is waste. */
  private final double[][] upper = new double[N][N];

  /** What was subtracted from each row of the rows above it. */
  private final double[][] lower = new double[N][N];

  /** The row of the matrix that each of these was made of. */
  private final int[] rows = new int[N];

  /**
   * Takes a matrix for {@link #solve}: Gauss elimination with row pivoting.
   *
   * @return false if the arm is singular
   */
  boolean factorise(double[] jacobian) {
    for (int i = 0; i < N; i++) {
      System.arraycopy(jacobian, N * i, upper[i], 0, N);
      rows[i] = i;
    }
    for (int step = 0; step < N; step++) {
      swapRows(step, pivotRow(step));
      double[] above = upper[step];
      double pivot = above[step];
      if (!(Math.abs(pivot) >= SINGULAR_PIVOT)) {
        return false;
      }
      for (int row = step + 1; row < N; row++) {
        double factor = upper[row][step] / pivot;
        lower[row][step] = factor;
        if (factor != 0) {
          subtract(factor, above, upper[row]);
        }
      }
    }
    return true;
  }

  /** Takes whole rows: a loop of a fixed length is the fastest. */
  private static void subtract(double factor, double[] above, double[] row) {
    for (int i = 0; i < N; i++) {
      row[i] -= factor * above[i];
    }
  }

  /** Solves for the matrix of the last {@link #factorise}, which has found it regular. */
  void solve(double[] twist, double[] qd) {
    double[] l1 = lower[1];
    double[] l2 = lower[2];
    double[] l3 = lower[3];
    double[] l4 = lower[4];
    double[] l5 = lower[5];
    double y0 = twist[rows[0]];
    double y1 = twist[rows[1]] - l1[0] * y0;
    double y2 = twist[rows[2]] - l2[0] * y0 - l2[1] * y1;
    double y3 = twist[rows[3]] - l3[0] * y0 - l3[1] * y1 - l3[2] * y2;
    double y4 = twist[rows[4]] - l4[0] * y0 - l4[1] * y1 - l4[2] * y2 - l4[3] * y3;
    double y5 = twist[rows[5]] - l5[0] * y0 - l5[1] * y1 - l5[2] * y2 - l5[3] * y3 - l5[4] * y4;
    double[] u0 = upper[0];
    double[] u1 = upper[1];
    double[] u2 = upper[2];
    double[] u3 = upper[3];
    double[] u4 = upper[4];
    double x5 = y5 / upper[5][5];
    double x4 = (y4 - u4[5] * x5) / u4[4];
    double x3 = (y3 - u3[4] * x4 - u3[5] * x5) / u3[3];
    double x2 = (y2 - u2[3] * x3 - u2[4] * x4 - u2[5] * x5) / u2[2];
    double x1 = (y1 - u1[2] * x2 - u1[3] * x3 - u1[4] * x4 - u1[5] * x5) / u1[1];
    double x0 = (y0 - u0[1] * x1 - u0[2] * x2 - u0[3] * x3 - u0[4] * x4 - u0[5] * x5) / u0[0];
    qd[0] = x0;
    qd[1] = x1;
    qd[2] = x2;
    qd[3] = x3;
    qd[4] = x4;
    qd[5] = x5;
  }

  /**
   * The normal equations {@code (JᵀJ + damping² I) qd = Jᵀ twist}, by their Cholesky factor; see
   * {@link Jacobian#solveDamped}. Where rounding leaves none, the speeds are not numbers.
   */
  void solveDamped(double[] jacobian, double[] twist, double damping, double[] qd) {
    matrix.setData(jacobian);
    side.setData(twist);
    speeds.setData(qd);
    CommonOps_DDRM.setIdentity(normal);
    CommonOps_DDRM.scale(damping * damping, normal);
    MatrixMatrixMult_DDRM.multAddTransA_reorder(matrix, matrix, normal);
    MatrixVectorMult_DDRM.multTransA_small(matrix, side, speeds);
    if (!UnrolledCholesky_DDRM.lower6(normal, factor)) {
      Arrays.fill(qd, Double.NaN);
      return;
    }
    TriangularSolver_DDRM.solveL(factor.data, qd, N);
    TriangularSolver_DDRM.solveTranL(factor.data, qd, N);
  }

  private int pivotRow(int step) {
    int best = step;
    double largest = Math.abs(upper[step][step]);
    for (int row = step + 1; row < N; row++) {
      double candidate = Math.abs(upper[row][step]);
      if (candidate > largest) {
        largest = candidate;
        best = row;
      }
    }
    return best;
  }

  private void swapRows(int a, int b) {
    if (a == b) {
      return;
    }
    double[] kept = upper[a];
    upper[a] = upper[b];
    upper[b] = kept;
    kept = lower[a];
    lower[a] = lower[b];
    lower[b] = kept;
    int origin = rows[a];
    rows[a] = rows[b];
    rows[b] = origin;
  }
}
