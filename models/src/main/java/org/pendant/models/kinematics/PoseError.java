package org.pendant.models.kinematics;

/**
 * Pose error: how far one frame is from another.
 *
 * @param positionM distance of the origins, m
 * @param orientationRad angle between the orientations, rad
 */
public record PoseError(double positionM, double orientationRad) {
  /**
   * The error between two transformations (see {@link org.pendant.models.pose.Transforms}).
   *
   * <p>The angle comes from the size of the difference of the matrices, {@code 2 sqrt(2) sin(angle
   * / 2)}, which keeps full precision for small angles.
   */
  static PoseError between(double[] a, double[] b) {
    return new PoseError(position(a, b), orientation(a, b));
  }

  /** True if neither error between the transformations is above the same small tolerance. */
  static boolean within(double[] a, double[] b, double tolerance) {
    double dx = a[9] - b[9];
    double dy = a[10] - b[10];
    double dz = a[11] - b[11];
    double sum = 0;
    for (int i = 0; i < 9; i++) {
      double difference = a[i] - b[i];
      sum += difference * difference;
    }
    double square = tolerance * tolerance;
    // 8 sin^2(angle / 2) is 2 angle^2 for small angles
    return dx * dx + dy * dy + dz * dz <= square && sum <= 2 * square;
  }

  private static double position(double[] a, double[] b) {
    double dx = a[9] - b[9];
    double dy = a[10] - b[10];
    double dz = a[11] - b[11];
    return Math.sqrt(dx * dx + dy * dy + dz * dz);
  }

  private static double orientation(double[] a, double[] b) {
    double sum = 0;
    for (int i = 0; i < 9; i++) {
      double difference = a[i] - b[i];
      sum += difference * difference;
    }
    return 2 * Math.asin(Math.min(1, Math.sqrt(0.125 * sum)));
  }

  /** True if neither error is above its limit; false if one is not a number. */
  public boolean within(double maxPositionM, double maxOrientationRad) {
    return positionM <= maxPositionM && orientationRad <= maxOrientationRad;
  }
}
