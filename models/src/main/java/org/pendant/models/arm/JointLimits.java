package org.pendant.models.arm;

/**
 * What one joint can do.
 *
 * @param minRad smallest position, rad
 * @param maxRad largest position, rad
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

  /** True if a position in rad lies within the range, its ends included. */
  public boolean contains(double positionRad) {
    return positionRad >= minRad && positionRad <= maxRad;
  }
}
