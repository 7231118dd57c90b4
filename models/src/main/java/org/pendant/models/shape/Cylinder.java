package org.pendant.models.shape;

/**
 * Cylinder around one axis of its body's frame; the place that has it says which axis.
 *
 * @param radiusM radius, m
 * @param fromM where it begins on the axis, m
 * @param toM where it ends, m
 */
public record Cylinder(double radiusM, double fromM, double toM) {
  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if the radius is not above 0, or the end not above the start
   */
  public Cylinder {
    if (!(radiusM > 0)) {
      throw new IllegalArgumentException("cylinder: radius is " + radiusM + " m, must be above 0");
    }
    if (!(fromM < toM)) {
      throw new IllegalArgumentException(
          "cylinder: goes from " + fromM + " m to " + toM + " m, the end must be above the begin");
    }
  }
}
