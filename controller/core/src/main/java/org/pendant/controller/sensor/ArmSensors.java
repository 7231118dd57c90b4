package org.pendant.controller.sensor;

import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.JointAngles;

/**
 * Readings of the sensors and drives of an arm after a frame. The numbers change with every frame:
 * readers within the frame loop copy what has to last.
 */
public interface ArmSensors {
  /** Positions as the encoders at the joints read them, rad. */
  Joints positionRad();

  /** Speeds as derived from the encoders, rad/s. */
  Joints speedRadPerS();

  /** Accelerations as derived from the encoders, rad/s². */
  Joints accelerationRadPerS2();

  /** Torques of the drives at the joints, from the motor currents, Nm. */
  Joints torqueNm();

  /**
   * Torques that arm and declared payload need for the motion that was measured, by the
   * controller's model, friction included, Nm. What {@link #torqueNm} has beyond them comes from
   * outside. All 0 while the motors are off: brakes feel nothing.
   */
  Joints modelTorqueNm();

  /** Torques that the target motion needs by the controller's model, Nm. */
  Joints targetTorqueNm();

  /** Motor currents, A. */
  Joints currentA();

  /** Motor current of joint {@code joint}, A. */
  double currentA(int joint);

  /** Motor currents that {@link #targetTorqueNm} needs, A. */
  Joints targetCurrentA();

  /** Temperatures of the joints, degrees Celsius. */
  Joints temperatureC();

  /** Temperature of the tool flange's electronics, degrees Celsius. */
  double toolTemperatureC();

  /** Reading {@code axis} (0 to 2) of the accelerometer in the tool flange, flange axes, m/s². */
  double toolAccelerationMPerS2(int axis);

  /**
   * Cosines and sines of the positions, which whoever computes something of them shares; of the
   * next ones in the next frame.
   */
  JointAngles angles();

  /** Writes the positions into six numbers; allocates nothing. */
  void copyPositionRad(double[] q);

  /** Writes the speeds into six numbers; allocates nothing. */
  void copySpeedRadPerS(double[] qd);

  /** What {@link #torqueNm} has beyond {@link #modelTorqueNm}, Nm. */
  Joints externalTorqueNm();

  /** What the torque of joint {@code joint} has beyond the model's, Nm. */
  double externalTorqueNm(int joint);
}
