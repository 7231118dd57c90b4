package org.pendant.controller.arm;

import java.util.Arrays;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

/**
 * An arm without mass, friction or delay: it is always exactly where it should be. Its motors feel
 * nothing, it touches nothing, and without a target it stays where it is, at once. Only the flange
 * feels something: the weight and inertia of the load in the target motion.
 */
public final class IdealArm implements SimulatedArm {
  private final Flange flange;
  private final ArmSensors sensors = new ArmSensors();
  private Payload load = Payload.NONE;
  private Joints positionRad;
  private Joints speedRadPerS = Joints.ZERO;
  private ArmCommand last = ArmCommand.BRAKES_ON;

  /**
   * An arm at rest.
   *
   * @param arm what it is made of
   * @param startRad where its joints are at first, rad
   */
  public IdealArm(ArmDescription arm, Joints startRad) {
    flange = new Flange(arm);
    Arrays.fill(sensors.temperatureC, JointHeat.AMBIENT_C);
    sensors.toolTemperatureC = JointHeat.AMBIENT_C;
    move(startRad, Joints.ZERO, Joints.ZERO);
  }

  @Override
  public void step(ArmCommand command) {
    if (command.equals(last)) {
      return;
    }
    last = command;
    switch (command) {
      case ArmCommand.Servo target ->
          move(target.positionRad(), target.speedRadPerS(), target.accelerationRadPerS2());
      case ArmCommand.Torque torque -> move(positionRad, Joints.ZERO, Joints.ZERO);
      case ArmCommand.BrakesOn brakes -> move(positionRad, Joints.ZERO, Joints.ZERO);
    }
  }

  @Override
  public void jumpTo(Joints positionRad) {
    last = ArmCommand.BRAKES_ON;
    move(positionRad, Joints.ZERO, Joints.ZERO);
  }

  private void move(Joints position, Joints speed, Joints acceleration) {
    positionRad = position;
    speedRadPerS = speed;
    position.copyTo(sensors.positionRad);
    speed.copyTo(sensors.speedRadPerS);
    acceleration.copyTo(sensors.accelerationRadPerS2);
    flange.update(sensors.positionRad, sensors.speedRadPerS, sensors.accelerationRadPerS2);
    flange.accelerometer(sensors.toolAccelerationMPerS2);
  }

  @Override
  public ArmSensors sensors() {
    return sensors;
  }

  @Override
  public Wrench loadOnFlange() {
    return flange.weightOf(load);
  }

  @Override
  public Wrench weightOf(Payload payload) {
    return flange.weightOf(payload);
  }

  @Override
  public void copyFlangeInBase(double[] flange12) {
    flange.copyInBase(flange12);
  }

  @Override
  public void setLoad(Payload load) {
    this.load = load;
  }

  @Override
  public void setMounting(double x, double y, double z) {
    flange.mount(x, y, z);
    move(positionRad, speedRadPerS, sensors.accelerationRadPerS2());
  }

  /** Has no effect: an ideal arm touches nothing. */
  @Override
  public void setToolCentre(Pose tcpInFlange) {}

  /** Has no effect: an ideal arm needs no model. */
  @Override
  public void modelChanged() {}

  @Override
  public Joints positionRad() {
    return positionRad;
  }

  @Override
  public Joints speedRadPerS() {
    return speedRadPerS;
  }
}
