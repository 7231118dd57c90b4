package org.pendant.controller.arm;

import org.pendant.controller.sensor.ArmSensors;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.JointAngles;

/** Sensor readings of a simulated arm; the arm writes them. */
public final class SimulatedSensors implements ArmSensors {
  final double[] positionRad = new double[Joints.COUNT];
  final double[] speedRadPerS = new double[Joints.COUNT];
  final double[] accelerationRadPerS2 = new double[Joints.COUNT];
  final double[] torqueNm = new double[Joints.COUNT];
  final double[] modelTorqueNm = new double[Joints.COUNT];
  final double[] targetTorqueNm = new double[Joints.COUNT];
  final double[] currentA = new double[Joints.COUNT];
  final TargetCurrent targetCurrent = new TargetCurrent();
  final double[] temperatureC = new double[Joints.COUNT];
  final double[] toolAccelerationMPerS2 = new double[3];
  double toolTemperatureC;

  /** Of the last positions that somebody asked for; see {@link #angles}. */
  final JointAngles angles = new JointAngles();

  /** By how much the force sensor errs, at the flange's origin along its axes. */
  final double[] flangeNoise6 = new double[6];

  /** Takes over what {@code others} say. */
  public void set(SimulatedSensors others) {
    System.arraycopy(others.positionRad, 0, positionRad, 0, Joints.COUNT);
    System.arraycopy(others.speedRadPerS, 0, speedRadPerS, 0, Joints.COUNT);
    System.arraycopy(others.accelerationRadPerS2, 0, accelerationRadPerS2, 0, Joints.COUNT);
    System.arraycopy(others.torqueNm, 0, torqueNm, 0, Joints.COUNT);
    System.arraycopy(others.modelTorqueNm, 0, modelTorqueNm, 0, Joints.COUNT);
    System.arraycopy(others.targetTorqueNm, 0, targetTorqueNm, 0, Joints.COUNT);
    System.arraycopy(others.currentA, 0, currentA, 0, Joints.COUNT);
    targetCurrent.set(others.targetCurrent);
    System.arraycopy(others.temperatureC, 0, temperatureC, 0, Joints.COUNT);
    System.arraycopy(others.toolAccelerationMPerS2, 0, toolAccelerationMPerS2, 0, 3);
    toolTemperatureC = others.toolTemperatureC;
    System.arraycopy(others.flangeNoise6, 0, flangeNoise6, 0, flangeNoise6.length);
  }

  @Override
  public Joints positionRad() {
    return Joints.of(positionRad);
  }

  @Override
  public Joints speedRadPerS() {
    return Joints.of(speedRadPerS);
  }

  /** How fast the fastest joint turns, rad/s. */
  public double fastestRadPerS() {
    double fastest = 0;
    for (double speed : speedRadPerS) {
      fastest = Math.max(fastest, Math.abs(speed));
    }
    return fastest;
  }

  @Override
  public Joints accelerationRadPerS2() {
    return Joints.of(accelerationRadPerS2);
  }

  @Override
  public Joints torqueNm() {
    return Joints.of(torqueNm);
  }

  @Override
  public Joints modelTorqueNm() {
    return Joints.of(modelTorqueNm);
  }

  @Override
  public Joints targetTorqueNm() {
    return Joints.of(targetTorqueNm);
  }

  @Override
  public Joints currentA() {
    return Joints.of(currentA);
  }

  @Override
  public double currentA(int joint) {
    return currentA[joint];
  }

  @Override
  public Joints targetCurrentA() {
    return targetCurrent.read(targetTorqueNm);
  }

  @Override
  public Joints temperatureC() {
    return Joints.of(temperatureC);
  }

  @Override
  public double toolTemperatureC() {
    return toolTemperatureC;
  }

  @Override
  public double toolAccelerationMPerS2(int axis) {
    return toolAccelerationMPerS2[axis];
  }

  @Override
  public JointAngles angles() {
    angles.at(positionRad);
    return angles;
  }

  @Override
  public void copyPositionRad(double[] q) {
    System.arraycopy(positionRad, 0, q, 0, Joints.COUNT);
  }

  @Override
  public void copySpeedRadPerS(double[] qd) {
    System.arraycopy(speedRadPerS, 0, qd, 0, Joints.COUNT);
  }

  @Override
  public Joints externalTorqueNm() {
    return new Joints(
        externalTorqueNm(0),
        externalTorqueNm(1),
        externalTorqueNm(2),
        externalTorqueNm(3),
        externalTorqueNm(4),
        externalTorqueNm(5));
  }

  @Override
  public double externalTorqueNm(int joint) {
    return torqueNm[joint] - modelTorqueNm[joint];
  }
}
