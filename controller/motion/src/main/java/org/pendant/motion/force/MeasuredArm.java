package org.pendant.motion.force;

/** Measured arm: where the arm is according to its sensors. */
public interface MeasuredArm {
  /**
   * Writes the positions of the joints into six numbers, rad.
   *
   * @param q overwritten
   */
  void copyPositionRad(double[] q);

  /**
   * Where the flange truly is in the base frame.
   *
   * @param flange12 overwritten, as {@link org.pendant.models.pose.Transforms} has it
   */
  void copyFlangeInBase(double[] flange12);
}
