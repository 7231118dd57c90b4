package org.pendant.models.mesh;

/**
 * Principal axes: those along which a symmetric matrix, such as that of inertia, is diagonal: those
 * that C. G. J. Jacobi's turns lead to from the axes that it is given in. Those that are principal
 * already stay.
 */
public final class PrincipalAxes {
  private static final int MAX_TURNS = 60;

  /** Products of inertia below this share of the moments are rounding. */
  private static final double NEGLIGIBLE = 1e-10;

  private PrincipalAxes() {}

  /**
   * Makes a symmetric matrix diagonal.
   *
   * @param matrix 3x3, rows; overwritten with the diagonal one
   * @param frame overwritten in its first nine numbers, rows, with the axes, which are columns
   */
  public static void turn(double[] matrix, double[] frame) {
    for (int i = 0; i < 9; i++) {
      frame[i] = i % 4 == 0 ? 1 : 0;
    }
    for (int turn = 0; turn < MAX_TURNS; turn++) {
      int p = 0;
      int q = 1;
      if (Math.abs(matrix[2]) > Math.abs(matrix[1])) {
        q = 2;
      }
      if (Math.abs(matrix[5]) > Math.abs(matrix[3 * p + q])) {
        p = 1;
        q = 2;
      }
      double off = matrix[3 * p + q];
      if (Math.abs(off) <= NEGLIGIBLE * (matrix[0] + matrix[4] + matrix[8])) {
        return;
      }
      double theta = (matrix[4 * q] - matrix[4 * p]) / (2 * off);
      double tangent = Math.copySign(1, theta) / (Math.abs(theta) + Math.hypot(theta, 1));
      double cosine = 1 / Math.hypot(tangent, 1);
      double sine = tangent * cosine;
      for (int k = 0; k < 3; k++) {
        rotate(matrix, 3 * k + p, 3 * k + q, cosine, sine);
      }
      for (int k = 0; k < 3; k++) {
        rotate(matrix, 3 * p + k, 3 * q + k, cosine, sine);
        rotate(frame, 3 * k + p, 3 * k + q, cosine, sine);
      }
    }
  }

  private static void rotate(double[] matrix, int one, int other, double cosine, double sine) {
    double a = matrix[one];
    double b = matrix[other];
    matrix[one] = cosine * a - sine * b;
    matrix[other] = sine * a + cosine * b;
  }
}
