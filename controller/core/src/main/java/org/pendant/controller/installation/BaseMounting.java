package org.pendant.controller.installation;

import org.pendant.controller.world.Vector3;
import org.pendant.models.dynamics.ArmDynamics;

/**
 * Base mounting: how the base stands.
 *
 * @param tiltRad of the base from upright, about its y axis; pi hangs it from a ceiling
 * @param rotationRad of the base about its own z axis
 */
public record BaseMounting(double tiltRad, double rotationRad) {
  /** Upright on the floor. */
  public static final BaseMounting FLOOR = new BaseMounting(0, 0);

  /**
   * What {@code set_gravity} is told (manual 16.48): the acceleration that the resting arm feels,
   * away from the earth, along the axes of the base, m/s².
   */
  public Vector3 gravityInBaseMPerS2() {
    double g = ArmDynamics.STANDARD_GRAVITY_M_PER_S2;
    // up, seen from a base that was tilted about its y axis and then turned about its own z axis
    return new Vector3(
        rounded(-g * Math.sin(tiltRad) * Math.cos(rotationRad)),
        rounded(g * Math.sin(tiltRad) * Math.sin(rotationRad)),
        rounded(g * Math.cos(tiltRad)));
  }

  /** Without the last digits, in which a sine of pi is not 0. */
  private static double rounded(double value) {
    return Math.rint(value * 1e9) / 1e9 + 0.0;
  }
}
