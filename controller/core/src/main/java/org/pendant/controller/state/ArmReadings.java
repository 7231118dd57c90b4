package org.pendant.controller.state;

import org.pendant.controller.box.Mounting;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Wrench;

/**
 * Arm readings: what sensors and drives report, and what the controller believes about the payload.
 *
 * @param accelerationRadPerS2 accelerations derived from the joint encoders, rad/s²
 * @param torqueNm torques of the drives at the joints, Nm
 * @param externalTorqueNm what they have beyond the controller's model of arm and payload, Nm
 * @param targetTorqueNm torques that the target motion needs by that model, Nm
 * @param currentA motor currents, A
 * @param targetCurrentA motor currents that the target motion needs, A
 * @param temperatureC of the joints, degrees Celsius
 * @param toolTemperatureC of the tool flange, degrees Celsius
 * @param controllerTemperatureC of the control box, degrees Celsius
 * @param toolCurrentA what the tool takes, A
 * @param toolAcceleration reading of the accelerometer in the tool flange
 * @param flangeWrenchInBase external wrench at the flange, along the axes of the base
 * @param rawFlangeWrench what the force sensor feels at the flange along its axes, with the weight
 *     of the payload and without its zero
 * @param payload what programs have declared
 * @param mounting gravity and acceleration of the base, as programs have declared them
 * @param voltages of the supply
 * @param robotCurrentA what the arm takes from its 48 V supply, A
 * @param energyConsumedJ energy that it has taken since the controller was switched on, J
 * @param energyDissipatedJ energy that it gave back in braking since then, J
 * @param momentumKgMPerS linear momentum of arm and declared payload, kg m/s
 * @param deviationRatio distance from the target as a share of what stops the arm, 0 to 1
 * @param collisionRatio push from outside as a share of what stops the arm, 0 to 1
 */
public record ArmReadings(
    Joints accelerationRadPerS2,
    Joints torqueNm,
    Joints externalTorqueNm,
    Joints targetTorqueNm,
    Joints currentA,
    Joints targetCurrentA,
    Joints temperatureC,
    double toolTemperatureC,
    double controllerTemperatureC,
    double toolCurrentA,
    Acceleration toolAcceleration,
    Wrench flangeWrenchInBase,
    Wrench rawFlangeWrench,
    Payload payload,
    Mounting mounting,
    SupplyVoltages voltages,
    double robotCurrentA,
    double energyConsumedJ,
    double energyDissipatedJ,
    double momentumKgMPerS,
    double deviationRatio,
    double collisionRatio) {

  /**
   * An acceleration along the axes of the flange.
   *
   * @param xMPerS2 along x, m/s²
   * @param yMPerS2 along y, m/s²
   * @param zMPerS2 along z, m/s²
   */
  public record Acceleration(double xMPerS2, double yMPerS2, double zMPerS2) {}
}
