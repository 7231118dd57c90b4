package org.pendant.controller.safety;

import static org.pendant.controller.safety.SafetyTexts.text;

/**
 * Safety plane, which the tool centre point, and the elbow if wanted, must not pass.
 *
 * @param name for messages
 * @param pointXM a point of the plane in the base frame, m
 * @param pointYM a point of the plane in the base frame, m
 * @param pointZM a point of the plane in the base frame, m
 * @param allowedSide from the plane towards the allowed side, along the axes of the base
 * @param applies when it restricts the arm, or that it switches to the reduced limits
 * @param elbow whether the elbow is meant, too
 */
public record SafetyPlane(
    String name,
    double pointXM,
    double pointYM,
    double pointZM,
    Axis allowedSide,
    Applies applies,
    boolean elbow) {
  /**
   * Checks name and point.
   *
   * @throws IllegalArgumentException if the name is blank or the point not finite
   */
  public SafetyPlane {
    if (name.isBlank()) {
      throw new IllegalArgumentException(text("planeNameBlank"));
    }
    if (!Double.isFinite(pointXM + pointYM + pointZM)) {
      throw new IllegalArgumentException(text("planePointRange", name, pointXM, pointYM, pointZM));
    }
  }

  /** How far a point of the base frame is on the allowed side, m; negative beyond the plane. */
  public double insideM(double x, double y, double z) {
    return allowedSide.dot(x - pointXM, y - pointYM, z - pointZM);
  }

  /** How far the tool, or the elbow if it is meant and worse, is on the allowed side, m. */
  double insideM(ArmPoints points) {
    double tool = insideM(points.tool(0), points.tool(1), points.tool(2));
    return elbow
        ? Math.min(tool, insideM(points.elbow(0), points.elbow(1), points.elbow(2)))
        : tool;
  }
}
