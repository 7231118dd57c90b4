package org.pendant.motion.force;

/**
 * Task deviation: how far the TCP is from its target, along or about a non-compliant axis of force
 * mode's task frame (manual 15.12).
 *
 * @param axis 0 to 2 for along x, y, z, 3 to 5 for about them
 * @param amount m or rad, at least 0
 * @param limit what would have been allowed, m or rad
 */
public record TaskDeviation(int axis, double amount, double limit) {
  private static final String NAMES = "xyz";

  /**
   * Checks the axis.
   *
   * @throws IllegalArgumentException if there is no such axis
   */
  public TaskDeviation {
    if (axis < 0 || axis >= 2 * NAMES.length()) {
      throw new IllegalArgumentException("axis is " + axis + ", must be 0 to 5");
    }
  }

  /** Whether it is about the axis rather than along it. */
  public boolean turned() {
    return axis >= NAMES.length();
  }

  /** The axis of the task frame, x, y or z. */
  public char axisName() {
    return NAMES.charAt(axis % NAMES.length());
  }
}
