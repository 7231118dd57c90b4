package org.pendant.controller.arm;

import org.pendant.models.arm.Joints;

/** Sensors that report what a test wants them to. */
public final class SensorReadings {
  private final SimulatedSensors sensors = new SimulatedSensors();

  /** The sensors to hand out; the same object always. */
  public SimulatedSensors sensors() {
    return sensors;
  }

  /** An arm in this state, rad and rad/s, with nothing from outside. */
  public void set(Joints positionRad, Joints speedRadPerS) {
    positionRad.copyTo(sensors.positionRad);
    speedRadPerS.copyTo(sensors.speedRadPerS);
  }

  /** What the torque of a joint has beyond the model's, Nm. */
  public void setExternalTorque(int joint, double torqueNm) {
    sensors.torqueNm[joint] = sensors.modelTorqueNm[joint] + torqueNm;
  }
}
