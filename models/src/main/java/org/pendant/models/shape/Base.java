package org.pendant.models.shape;

/**
 * Foot of an arm: upright on the z axis of the base frame, from z = 0.
 *
 * @param heightM up to where the shoulder begins, m
 * @param footRadiusM at the bottom, m
 * @param topRadiusM at the top, m
 */
public record Base(double heightM, double footRadiusM, double topRadiusM) {
  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if one is not above 0
   */
  public Base {
    if (!(heightM > 0) || !(footRadiusM > 0) || !(topRadiusM > 0)) {
      throw new IllegalArgumentException(
          "base: height is "
              + heightM
              + " m, radii are "
              + footRadiusM
              + " m and "
              + topRadiusM
              + " m, all must be above 0");
    }
  }
}
