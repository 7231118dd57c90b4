package org.pendant.models.shape;

/**
 * The tube of a limb, parallel to x. Its radius was taken at three places of the limb's length.
 *
 * @param centreZM where its axis lies on z, m
 * @param nearRadiusM at 30 %, m
 * @param middleRadiusM at 50 %, m
 * @param farRadiusM at 70 %, m
 */
public record Tube(double centreZM, double nearRadiusM, double middleRadiusM, double farRadiusM) {
  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if a radius is not above 0
   */
  public Tube {
    if (!(nearRadiusM > 0) || !(middleRadiusM > 0) || !(farRadiusM > 0)) {
      throw new IllegalArgumentException(
          "tube: radii are "
              + nearRadiusM
              + ", "
              + middleRadiusM
              + " and "
              + farRadiusM
              + " m, all must be above 0");
    }
  }
}
