package org.pendant.controller.world;

import org.pendant.cell.BodyDescription;
import org.pendant.models.json.Range;
import org.pendant.models.pose.Pose;

/** Scene ranges: what lengths and angles in a scene may be. */
final class SceneRange {
  /** Where something may be, in the base frame: several times as far as the longest arm reaches. */
  static final Range POSITION = new Range(-10, 10, "m");

  /** Far more than any way of writing an orientation needs; keeps sines exact. */
  static final Range ROTATION = new Range(-100, 100, "rad");

  /** From a thin sheet to a hall. */
  static final Range SIZE = new Range(0.001, 10, "m");

  /** From a coin to a machine. */
  static final Range MASS = BodyDescription.MASS;

  private SceneRange() {}

  /** Whether something may be at a pose. */
  static boolean holds(Pose pose) {
    return POSITION.holds(pose.x()) && POSITION.holds(pose.y()) && POSITION.holds(pose.z());
  }

  /**
   * Checks what an object weighs.
   *
   * @throws IllegalArgumentException if it is outside; 0 is that of one that stands still
   */
  static void requireMass(double massKg) {
    if (massKg != 0) {
      MASS.require("mass", massKg);
    }
  }
}
