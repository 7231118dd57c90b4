package org.pendant.cell;

import org.pendant.models.json.Range;
import org.pendant.models.pose.Pose;

/**
 * Body description: a rigid body as it is at first.
 *
 * @param name how it is called; unique in its world
 * @param shape what it fills
 * @param poseInBase where its origin is, m, each -10 to 10, and its orientation, rad, each -100 to
 *     100; its centre of gravity is there too
 * @param massKg its mass, kg, 0.001 to 1000, evenly spread; of no effect unless it is free
 * @param surface how it feels
 * @param motion what moves it
 */
public record BodyDescription(
    String name,
    BodyShape shape,
    Pose poseInBase,
    double massKg,
    BodySurface surface,
    BodyMotion motion) {
  /** From a coin to a machine. */
  public static final Range MASS = new Range(0.001, 1000, "kg");

  /** Several times as far as the longest arm reaches. */
  static final Range POSITION = new Range(-10, 10, "m");

  /** Far more than any way of writing an orientation needs; keeps sines exact. */
  static final Range ROTATION = new Range(-100, 100, "rad");

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if one is outside its range, or if a shape is to move that
   *     cannot
   */
  public BodyDescription {
    for (int i = 0; i < Pose.SIZE; i++) {
      (i < 3 ? POSITION : ROTATION).require("pose[" + i + "]", poseInBase.get(i));
    }
    MASS.require("mass", massKg);
    if (staysStill(shape) && motion != BodyMotion.FIXED) {
      throw new IllegalArgumentException(name + ": has a shape that cannot move, must be fixed");
    }
  }

  private static boolean staysStill(BodyShape shape) {
    return shape instanceof BodyShape.HalfSpace
        || shape instanceof BodyShape.Faces
        || (shape instanceof BodyShape.Compound compound
            && compound.parts().stream().anyMatch(part -> staysStill(part.shape())));
  }

  /** A body that weight and contacts move. */
  public static BodyDescription free(
      String name, BodyShape shape, Pose poseInBase, double massKg, BodySurface surface) {
    return new BodyDescription(name, shape, poseInBase, massKg, surface, BodyMotion.FREE);
  }

  /** A body that nothing moves. */
  public static BodyDescription fixed(
      String name, BodyShape shape, Pose poseInBase, BodySurface surface) {
    return new BodyDescription(name, shape, poseInBase, 1, surface, BodyMotion.FIXED);
  }

  /** A body that {@link RigidBodyWorld#moveKinematic} moves. */
  public static BodyDescription kinematic(
      String name, BodyShape shape, Pose poseInBase, BodySurface surface) {
    return new BodyDescription(name, shape, poseInBase, 1, surface, BodyMotion.KINEMATIC);
  }
}
