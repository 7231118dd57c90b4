package org.pendant.controller.device.gripper;

/**
 * Part between the fingers of a gripper: a rigid one of a width that somebody has set.
 *
 * @param widthM above 0. A part that is wider than the fingers are open is not between them.
 */
public record PartBetween(double widthM) implements FingerSpace {
  /** What may lie between fingers that are set one micrometre closer than the part, m. */
  private static final double SLACK_M = 1e-6;

  @Override
  public double closesToM(double openingM, double forceN) {
    return widthM <= openingM + SLACK_M ? Math.min(widthM, openingM) : 0;
  }

  /** What a width stands for: 0 is none. */
  public static FingerSpace of(double widthM) {
    return widthM > 0 ? new PartBetween(widthM) : FREE;
  }
}
