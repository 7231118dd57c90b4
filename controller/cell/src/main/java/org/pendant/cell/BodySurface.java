package org.pendant.cell;

import org.pendant.models.json.Range;

/**
 * Body surface: how a body feels where others touch it.
 *
 * @param friction coefficient of friction, 0 to 2; between two bodies it is the geometric mean of
 *     theirs
 * @param restitution share of its speed with which an impact ends, 0 to 1; between two bodies the
 *     larger one counts
 * @param stiffnessNPerM force for each metre of depth where a kinematic body is pressed against
 *     another, N/m, 10 to 200,000; the softer of the two counts
 */
public record BodySurface(double friction, double restitution, double stiffnessNPerM) {
  /** What is allowed as friction. */
  public static final Range FRICTION = new Range(0, 2, "");

  /** What is allowed as restitution. */
  public static final Range RESTITUTION = new Range(0, 1, "");

  /** What is allowed as stiffness. */
  public static final Range STIFFNESS = new Range(10, 200_000, "N/m");

  /** Wood or plastic: slides from 17 degrees on, hardly bounces. */
  public static final BodySurface DEFAULT = new BodySurface(0.3, 0, 40_000);

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if one is outside its range
   */
  public BodySurface {
    FRICTION.require("friction", friction);
    RESTITUTION.require("restitution", restitution);
    STIFFNESS.require("stiffness", stiffnessNPerM);
  }
}
