package org.pendant.models.dynamics;

/**
 * Gravity as an arm feels it that rests: the acceleration away from the earth, along the axes of
 * the base.
 *
 * @param xMPerS2 along x, m/s²
 * @param yMPerS2 along y, m/s²
 * @param zMPerS2 along z, m/s²
 */
public record Gravity(double xMPerS2, double yMPerS2, double zMPerS2) {
  /** Of an arm that stands upright on the floor. */
  public static final Gravity UPRIGHT = new Gravity(0, 0, ArmDynamics.STANDARD_GRAVITY_M_PER_S2);

  /** Lets an arm feel it. */
  public void applyTo(ArmDynamics dynamics) {
    dynamics.setGravity(xMPerS2, yMPerS2, zMPerS2);
  }
}
