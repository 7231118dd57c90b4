package org.pendant.controller.arm;

import org.pendant.models.arm.Joints;

/**
 * What the arm's sensors and drives report after a frame. The arm writes it; everybody else reads
 * it within the frame loop and copies what has to last.
 */
public final class ArmSensors {
  final double[] positionRad = new double[Joints.COUNT];
  final double[] speedRadPerS = new double[Joints.COUNT];
  final double[] accelerationRadPerS2 = new double[Joints.COUNT];
  final double[] torqueNm = new double[Joints.COUNT];
  final double[] modelTorqueNm = new double[Joints.COUNT];
  final double[] targetTorqueNm = new double[Joints.COUNT];
  final double[] currentA = new double[Joints.COUNT];
  final double[] targetCurrentA = new double[Joints.COUNT];
  final double[] temperatureC = new double[Joints.COUNT];
  final double[] toolAccelerationMPerS2 = new double[3];
  double toolTemperatureC;

  /** Positions as the encoders at the joints read them, rad. */
  public Joints positionRad() {
    return Joints.of(positionRad);
  }

  /** Speeds as derived from the encoders, rad/s. */
  public Joints speedRadPerS() {
    return Joints.of(speedRadPerS);
  }

  /** Accelerations as derived from the encoders, rad/s². */
  public Joints accelerationRadPerS2() {
    return Joints.of(accelerationRadPerS2);
  }

  /** Torques of the drives at the joints, from the motor currents, Nm. */
  public Joints torqueNm() {
    return Joints.of(torqueNm);
  }

  /**
   * Torques that arm and declared payload need for the motion that was measured, by the
   * controller's model, friction included, Nm. What {@link #torqueNm} has beyond them comes from
   * outside. All 0 while the motors are off: brakes feel nothing.
   */
  public Joints modelTorqueNm() {
    return Joints.of(modelTorqueNm);
  }

  /** Torques that the target motion needs by the controller's model, Nm. */
  public Joints targetTorqueNm() {
    return Joints.of(targetTorqueNm);
  }

  /** Motor currents, A. */
  public Joints currentA() {
    return Joints.of(currentA);
  }

  /** Motor currents that {@link #targetTorqueNm} needs, A. */
  public Joints targetCurrentA() {
    return Joints.of(targetCurrentA);
  }

  /** Temperatures of the joints, degrees Celsius. */
  public Joints temperatureC() {
    return Joints.of(temperatureC);
  }

  /** Temperature of the tool flange's electronics, degrees Celsius. */
  public double toolTemperatureC() {
    return toolTemperatureC;
  }

  /** Reading {@code axis} (0 to 2) of the accelerometer in the tool flange, flange axes, m/s². */
  public double toolAccelerationMPerS2(int axis) {
    return toolAccelerationMPerS2[axis];
  }

  /** Writes the positions into six numbers; allocates nothing. */
  public void copyPositionRad(double[] q) {
    System.arraycopy(positionRad, 0, q, 0, Joints.COUNT);
  }

  /** Writes the speeds into six numbers; allocates nothing. */
  public void copySpeedRadPerS(double[] qd) {
    System.arraycopy(speedRadPerS, 0, qd, 0, Joints.COUNT);
  }

  /** What {@link #torqueNm} has beyond {@link #modelTorqueNm}, Nm. */
  public Joints externalTorqueNm() {
    return new Joints(
        externalTorqueNm(0),
        externalTorqueNm(1),
        externalTorqueNm(2),
        externalTorqueNm(3),
        externalTorqueNm(4),
        externalTorqueNm(5));
  }

  /** What the torque of joint {@code joint} has beyond the model's, Nm. */
  public double externalTorqueNm(int joint) {
    return torqueNm[joint] - modelTorqueNm[joint];
  }
}
