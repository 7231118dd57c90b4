package org.pendant.models.arm;

/**
 * Mass, centre of mass and inertia of one link, in the Denavit-Hartenberg frame at its far end.
 *
 * <p>The inertia is the tensor about the centre of mass with axes parallel to that frame; {@code
 * ixy} and the like are its elements as they stand, without change of sign.
 *
 * @param name the link
 * @param massKg mass, kg
 * @param comXM centre of mass, m
 * @param comYM centre of mass, m
 * @param comZM centre of mass, m
 * @param ixx inertia, kg m²
 * @param ixy inertia, kg m²
 * @param ixz inertia, kg m²
 * @param iyy inertia, kg m²
 * @param iyz inertia, kg m²
 * @param izz inertia, kg m²
 */
public record LinkMass(
    String name,
    double massKg,
    double comXM,
    double comYM,
    double comZM,
    double ixx,
    double ixy,
    double ixz,
    double iyy,
    double iyz,
    double izz) {
  /**
   * Checks the mass.
   *
   * @throws IllegalArgumentException if it is not above 0
   */
  public LinkMass {
    if (!(massKg > 0)) {
      throw new IllegalArgumentException(
          "link " + name + ": mass is " + massKg + " kg, must be above 0");
    }
  }
}
