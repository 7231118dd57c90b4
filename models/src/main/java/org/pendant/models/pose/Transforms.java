package org.pendant.models.pose;

/**
 * Poses as rotation matrix and position, for code that runs every frame.
 *
 * <p>A transformation is a {@code double[12]}: the rotation matrix in rows ({@code 0..8}, so every
 * method of {@link Rotations} takes the same array), then the position in m ({@code 9..11}).
 * Methods write into their last parameter and allocate nothing.
 */
public final class Transforms {
  /** Numbers in a transformation. */
  public static final int SIZE = 12;

  private Transforms() {}

  /** The transformation of a pose. */
  public static void of(Pose pose, double[] transform) {
    Rotations.vectorToMatrix(pose.rx(), pose.ry(), pose.rz(), transform);
    transform[9] = pose.x();
    transform[10] = pose.y();
    transform[11] = pose.z();
  }

  /** The pose of a transformation. */
  public static Pose toPose(double[] transform) {
    double[] vector = new double[3];
    Rotations.matrixToVector(transform, vector);
    return new Pose(transform[9], transform[10], transform[11], vector[0], vector[1], vector[2]);
  }

  /** The product {@code a b}; {@code product} must be neither of them. */
  public static void multiply(double[] a, double[] b, double[] product) {
    for (int row = 0; row < 3; row++) {
      double m0 = a[3 * row];
      double m1 = a[3 * row + 1];
      double m2 = a[3 * row + 2];
      product[3 * row] = m0 * b[0] + m1 * b[3] + m2 * b[6];
      product[3 * row + 1] = m0 * b[1] + m1 * b[4] + m2 * b[7];
      product[3 * row + 2] = m0 * b[2] + m1 * b[5] + m2 * b[8];
      product[9 + row] = m0 * b[9] + m1 * b[10] + m2 * b[11] + a[9 + row];
    }
  }

  /** The inverse of {@code t}; {@code inverse} must be another array. */
  public static void invert(double[] t, double[] inverse) {
    for (int row = 0; row < 3; row++) {
      inverse[3 * row] = t[row];
      inverse[3 * row + 1] = t[3 + row];
      inverse[3 * row + 2] = t[6 + row];
      inverse[9 + row] = -(t[row] * t[9] + t[3 + row] * t[10] + t[6 + row] * t[11]);
    }
  }
}
