package org.pendant.controller.safety;

/**
 * How far the TCP is from where it should be, along or about an axis of force mode's task frame
 * that does not give way (manual 15.12).
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

  /** The stop that it calls for, on account of joint {@code joint} (0 to 5). */
  SafetyStop stop(int joint, double timeS) {
    boolean turned = axis >= NAMES.length();
    StopReason reason = turned ? StopReason.FORCE_MODE_TURN : StopReason.FORCE_MODE_SHIFT;
    return reason.alongAxis(NAMES.charAt(axis % NAMES.length()), joint, timeS, amount, limit);
  }
}
