package org.pendant.controller.safety;

import static org.pendant.controller.safety.SafetyTexts.text;

/**
 * Tool direction limit: how far the tool may be tilted.
 *
 * @param allowedInBase where the tool should point, along the axes of the base
 * @param toolInFlange the tool's own direction, along the axes of the flange
 * @param largestAngleRad the largest angle between the two, above 0 and below pi, rad
 * @param applies when it restricts the arm; not {@link Applies#TRIGGERS_REDUCED}
 */
public record ToolDirection(
    Axis allowedInBase, Axis toolInFlange, double largestAngleRad, Applies applies) {
  /**
   * Checks the angle.
   *
   * @throws IllegalArgumentException if it is not within 0 to pi, or the direction should trigger
   *     the reduced mode, which only planes do
   */
  public ToolDirection {
    if (!(largestAngleRad > 0 && largestAngleRad < Math.PI)) {
      throw new IllegalArgumentException(text("tiltRange", largestAngleRad));
    }
    if (applies == Applies.TRIGGERS_REDUCED) {
      throw new IllegalArgumentException(text("tiltTriggersReduced"));
    }
  }

  /** The angle between tool and allowed direction, 0 to pi, rad. */
  double angleRad(ArmPoints points) {
    return Math.acos(Math.clamp(cosine(points), -1, 1));
  }

  /** How fast that angle grows, rad/s. */
  double angleSpeedRadPerS(ArmPoints points) {
    double cosine = cosine(points);
    double sine = Math.sqrt(Math.max(0, 1 - cosine * cosine));
    // t' = w x t for the tool axis t, and the angle's cosine is a . t
    double tx = points.toolAxis(0);
    double ty = points.toolAxis(1);
    double tz = points.toolAxis(2);
    double wx = points.turn(0);
    double wy = points.turn(1);
    double wz = points.turn(2);
    double dx = wy * tz - wz * ty;
    double dy = wz * tx - wx * tz;
    double dz = wx * ty - wy * tx;
    // at angle 0 or pi every tilt changes it by as much as the tool turns across itself
    return sine > 1e-6
        ? -allowedInBase.dot(dx, dy, dz) / sine
        : Math.signum(cosine) * Math.sqrt(dx * dx + dy * dy + dz * dz);
  }

  private double cosine(ArmPoints points) {
    return allowedInBase.dot(points.toolAxis(0), points.toolAxis(1), points.toolAxis(2));
  }
}
