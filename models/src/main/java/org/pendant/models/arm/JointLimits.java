package org.pendant.models.arm;

/**
 * Joint limits: what one joint is capable of.
 *
 * @param minRad smallest position by the data sheet, rad; minus infinity for a joint that turns
 *     without end
 * @param maxRad largest position by the data sheet, rad; infinity for a joint that turns without
 *     end
 * @param maxSpeedRadPerS largest speed either way, rad/s
 * @param maxTorqueNm largest torque either way, Nm
 */
public record JointLimits(
    double minRad, double maxRad, double maxSpeedRadPerS, double maxTorqueNm) {
  /** How far beyond its range the standard safety limits let a joint turn, rad. */
  private static final double BEYOND_RAD = Math.toRadians(3);

  /**
   * Checks the limits.
   *
   * @throws IllegalArgumentException if the range is empty, or speed or torque is not above 0
   */
  public JointLimits {
    if (!(minRad < maxRad)) {
      throw new IllegalArgumentException(
          "joint limits: minRad is " + minRad + ", must be below maxRad " + maxRad);
    }
    if (!(maxSpeedRadPerS > 0) || !(maxTorqueNm > 0)) {
      throw new IllegalArgumentException(
          "joint limits: speed is "
              + maxSpeedRadPerS
              + " rad/s and torque "
              + maxTorqueNm
              + " Nm, both must be above 0");
    }
  }

  /** Whether the joint turns without end. */
  public boolean unlimited() {
    return minRad == Double.NEGATIVE_INFINITY && maxRad == Double.POSITIVE_INFINITY;
  }

  /**
   * The lowest position that standard safety limits allow, rad: {@code minRad} is what the data
   * sheet says, and what a robot can be told is 3° more, -363° for most joints.
   */
  public double lowestRad() {
    return minRad - BEYOND_RAD;
  }

  /** The highest position that standard safety limits allow, rad. */
  public double highestRad() {
    return maxRad + BEYOND_RAD;
  }

  /** True if a position in rad is one that standard safety limits allow. */
  public boolean contains(double positionRad) {
    return positionRad >= lowestRad() && positionRad <= highestRad();
  }
}
