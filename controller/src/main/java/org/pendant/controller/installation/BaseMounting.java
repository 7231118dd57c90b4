package org.pendant.controller.installation;

/**
 * How the base is mounted.
 *
 * @param tiltRad of the base from upright, about its y axis; pi hangs it from a ceiling
 * @param rotationRad of the base about its own z axis
 */
public record BaseMounting(double tiltRad, double rotationRad) {
  /** Upright on the floor. */
  public static final BaseMounting FLOOR = new BaseMounting(0, 0);
}
