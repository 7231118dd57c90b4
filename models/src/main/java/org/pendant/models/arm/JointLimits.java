package org.pendant.models.arm;

/**
 * What one joint can do.
 *
 * @param minRad smallest position, rad; minus infinity for a joint that turns without end
 * @param maxRad largest position, rad; infinity for a joint that turns without end
 * @param maxSpeedRadPerS largest speed either way, rad/s
 * @param maxTorqueNm largest torque either way, Nm
 */
public record JointLimits(
    double minRad, double maxRad, double maxSpeedRadPerS, double maxTorqueNm) {
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

  /** True if a position in rad lies within the range, its ends included. */
  public boolean contains(double positionRad) {
    return positionRad >= minRad && positionRad <= maxRad;
  }
}
