package org.pendant.models.arm;

/**
 * The drive of one joint: motor, gear and bearings, seen from the joint.
 *
 * <p>No manufacturer publishes these numbers; the descriptions carry estimates of ours.
 *
 * @param rotorInertiaKgM2 inertia of the motor behind the gear, kg m²
 * @param coulombNm friction that does not depend on the speed, Nm
 * @param viscousNmSPerRad friction that grows with the speed, Nm s/rad
 * @param torqueConstantNmPerA torque that one ampere gives, Nm/A
 */
public record Actuator(
    double rotorInertiaKgM2,
    double coulombNm,
    double viscousNmSPerRad,
    double torqueConstantNmPerA) {
  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if one is negative, or the torque constant not above 0
   */
  public Actuator {
    if (!(rotorInertiaKgM2 >= 0) || !(coulombNm >= 0) || !(viscousNmSPerRad >= 0)) {
      throw new IllegalArgumentException(
          "actuator: rotor inertia is "
              + rotorInertiaKgM2
              + " kg m\u00b2, Coulomb friction "
              + coulombNm
              + " Nm, viscous friction "
              + viscousNmSPerRad
              + " Nm s/rad, none may be negative");
    }
    if (!(torqueConstantNmPerA > 0)) {
      throw new IllegalArgumentException(
          "actuator: torque constant is " + torqueConstantNmPerA + " Nm/A, must be above 0");
    }
  }
}
