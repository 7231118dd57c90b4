package org.pendant.motion.offset;

/**
 * Rotation products of matrices that are each the first nine entries of an array; see {@link
 * org.pendant.models.pose.Rotations}.
 */
final class Turns {
  private Turns() {}

  /** The product {@code a b}; {@code product} must be neither of them. */
  static void multiply(double[] a, double[] b, double[] product) {
    for (int row = 0; row < 9; row += 3) {
      for (int column = 0; column < 3; column++) {
        product[row + column] =
            a[row] * b[column] + a[row + 1] * b[3 + column] + a[row + 2] * b[6 + column];
      }
    }
  }

  /** The product of {@code a} and the transpose of {@code b}. */
  static void multiplyTransposed(double[] a, double[] b, double[] product) {
    for (int row = 0; row < 9; row += 3) {
      for (int column = 0; column < 3; column++) {
        int of = 3 * column;
        product[row + column] = a[row] * b[of] + a[row + 1] * b[of + 1] + a[row + 2] * b[of + 2];
      }
    }
  }

  /** The product of the transpose of {@code a} and a vector; writes the first three entries. */
  static void turnBack(double[] a, double x, double y, double z, double[] turned) {
    turned[0] = a[0] * x + a[3] * y + a[6] * z;
    turned[1] = a[1] * x + a[4] * y + a[7] * z;
    turned[2] = a[2] * x + a[5] * y + a[8] * z;
  }
}
