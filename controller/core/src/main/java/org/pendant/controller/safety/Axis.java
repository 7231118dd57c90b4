package org.pendant.controller.safety;

import static org.pendant.controller.safety.SafetyTexts.text;

/** Axis: a direction, three numbers of length 1 along the axes of a frame that the user names. */
public record Axis(double x, double y, double z) {
  /** A shorter vector has no direction worth the name. */
  static final double SHORTEST = 1e-3;

  /** What rounding leaves of a length that was made 1: making it 1 again changes nothing. */
  private static final double ROUNDING = 1e-15;

  /**
   * Makes the length 1.
   *
   * @throws IllegalArgumentException if the length is below 0.001 or not finite
   */
  public Axis {
    double length = Math.sqrt(x * x + y * y + z * z);
    if (!(length >= SHORTEST && length < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(text("axisRange", x, y, z, SHORTEST));
    }
    if (Math.abs(length - 1) > ROUNDING) {
      x /= length;
      y /= length;
      z /= length;
    }
  }

  /** Length of a vector's component along this direction, in the vector's unit. */
  double dot(double vx, double vy, double vz) {
    return x * vx + y * vy + z * vz;
  }
}
