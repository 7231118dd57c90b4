package org.pendant.models.shape;

/**
 * The upper arm or the forearm: a housing around the joint at either end, and a tube between them.
 *
 * @param lengthM from joint axis to joint axis, m; the far axis goes through x = -length
 * @param near along z, at x = 0
 * @param far along z, at x = -length
 * @param tube between the two
 */
public record Limb(double lengthM, Cylinder near, Cylinder far, Tube tube) {
  /**
   * Checks the length.
   *
   * @throws IllegalArgumentException if it is not above 0
   */
  public Limb {
    if (!(lengthM > 0)) {
      throw new IllegalArgumentException("limb: length is " + lengthM + " m, must be above 0");
    }
  }
}
