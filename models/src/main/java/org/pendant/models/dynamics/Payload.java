package org.pendant.models.dynamics;

/**
 * Payload: what is mounted on the flange (manual 16.52).
 *
 * @param massKg mass, kg
 * @param cogXM centre of gravity in the flange frame, m
 * @param cogYM centre of gravity in the flange frame, m
 * @param cogZM centre of gravity in the flange frame, m
 * @param ixx inertia about the centre of gravity along the axes of the flange, kg m²
 * @param iyy inertia, kg m²
 * @param izz inertia, kg m²
 * @param ixy inertia, kg m²; the tensor's element as it stands
 * @param ixz inertia, kg m²
 * @param iyz inertia, kg m²
 */
public record Payload(
    double massKg,
    double cogXM,
    double cogYM,
    double cogZM,
    double ixx,
    double iyy,
    double izz,
    double ixy,
    double ixz,
    double iyz) {
  /** Nothing. */
  public static final Payload NONE = new Payload(0, 0, 0, 0, 0, 0, 0, 0, 0, 0);

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if the mass is negative or a number not finite
   */
  public Payload {
    if (!(massKg >= 0)) {
      throw new IllegalArgumentException("payload: mass is " + massKg + " kg, must be at least 0");
    }
    requireFinite("mass", massKg);
    requireFinite("cog x", cogXM);
    requireFinite("cog y", cogYM);
    requireFinite("cog z", cogZM);
    requireFinite("Ixx", ixx);
    requireFinite("Iyy", iyy);
    requireFinite("Izz", izz);
    requireFinite("Ixy", ixy);
    requireFinite("Ixz", ixz);
    requireFinite("Iyz", iyz);
  }

  private static void requireFinite(String name, double value) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(
          "payload: " + name + " is " + value + ", must be a finite number");
    }
  }

  /**
   * A point mass.
   *
   * @param massKg mass, kg
   * @param x its place in the flange frame, m
   * @param y its place in the flange frame, m
   * @param z its place in the flange frame, m
   */
  public static Payload of(double massKg, double x, double y, double z) {
    return new Payload(massKg, x, y, z, 0, 0, 0, 0, 0, 0);
  }

  /**
   * A payload between this one and another, every number on the straight line between both.
   *
   * @param share 0 for this one, 1 for the other
   */
  public Payload between(Payload to, double share) {
    return new Payload(
        mix(massKg, to.massKg, share),
        mix(cogXM, to.cogXM, share),
        mix(cogYM, to.cogYM, share),
        mix(cogZM, to.cogZM, share),
        mix(ixx, to.ixx, share),
        mix(iyy, to.iyy, share),
        mix(izz, to.izz, share),
        mix(ixy, to.ixy, share),
        mix(ixz, to.ixz, share),
        mix(iyz, to.iyz, share));
  }

  private static double mix(double a, double b, double share) {
    return a + share * (b - a);
  }
}
