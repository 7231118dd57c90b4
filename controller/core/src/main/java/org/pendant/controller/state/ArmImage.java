package org.pendant.controller.state;

import java.util.Optional;
import org.pendant.controller.arm.SimulatedSensors;
import org.pendant.controller.arm.SupplyMeter;
import org.pendant.controller.arm.WarmUp;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.box.Mounting;
import org.pendant.controller.box.ToolCentre;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.JointNumbers;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.WrenchNumbers;
import org.pendant.motion.MotionControl;
import org.pendant.motion.MotionFailure;

/**
 * What the {@link ArmState} and the {@link ArmReadings} of a frame are made of. The next frame
 * writes over it, so that nothing is allocated for frames that nobody looks at.
 */
public final class ArmImage {
  private final JointNumbers targetPositionRad = new JointNumbers();
  private final JointNumbers targetSpeedRadPerS = new JointNumbers();
  private final JointNumbers targetAccelerationRadPerS2 = new JointNumbers();
  private final JointNumbers actualPositionRad = new JointNumbers();
  private final SimulatedSensors sensors = new SimulatedSensors();
  private ToolCentre tool = ToolCentre.FLANGE;
  private ArmDescription description;
  private ForwardKinematics kinematics;
  private ControlMode controlMode = ControlMode.POSITION;
  private boolean moving;
  private boolean steady;
  private double speedFraction;
  private double speedScaling;
  private Optional<MotionFailure> fault = Optional.empty();

  private double timeS;
  private double toolCurrentA;
  private final WrenchNumbers flangeWrenchInBase = new WrenchNumbers();
  private final WrenchNumbers rawFlangeWrench = new WrenchNumbers();
  private Payload payload;
  private Mounting mounting;
  private boolean robotPowered;
  private double boxV;
  private double robotV;
  private final double[] jointV = new double[Joints.COUNT];
  private double robotCurrentA;
  private double energyConsumedJ;
  private double energyDissipatedJ;
  private double momentumKgMPerS;
  private double deviationRatio;
  private double collisionRatio;

  /** An image of {@code box} as it is now. */
  public ArmImage(ControlBox box) {
    description = box.arm().description();
    kinematics = box.kinematics().forward();
    payload = box.arm().model().payload();
    mounting = box.arm().model().mounting();
    take(box, controlMode);
  }

  /** Takes what is so in this frame; allocates nothing. */
  public void take(ControlBox box, ControlMode mode) {
    MotionControl motion = box.motion();
    motion.readPositionRad(targetPositionRad);
    motion.readSpeedRadPerS(targetSpeedRadPerS);
    motion.readAccelerationRadPerS2(targetAccelerationRadPerS2);
    box.drive().readActualPositionRad(actualPositionRad);
    sensors.set(box.arm().simulated().sensors());
    tool = box.flange().tool();
    description = box.arm().description();
    kinematics = box.kinematics().forward();
    controlMode = mode;
    moving = motion.moving();
    steady = motion.steady();
    speedFraction = motion.speedFraction();
    speedScaling = motion.scaling();
    fault = motion.fault();
    timeS = box.clock().timeS();
    toolCurrentA = box.signals().toolCurrentA(box.drive().powered());
    flangeWrenchInBase.set(box.flange().wrenchInBase());
    rawFlangeWrench.set(box.flange().rawWrench());
    payload = box.arm().model().payload();
    mounting = box.arm().model().mounting();
    takeVoltages(box);
    robotCurrentA = box.arm().supplyMeter().currentA();
    energyConsumedJ = box.arm().supply().consumedJ();
    energyDissipatedJ = box.arm().supply().dissipatedJ();
    momentumKgMPerS = box.safety().momentumKgMPerS();
    deviationRatio = box.safety().deviationRatio();
    collisionRatio = box.safety().collisionRatio();
  }

  private void takeVoltages(ControlBox box) {
    SupplyMeter meter = box.arm().supplyMeter();
    robotPowered = RobotBits.powerOn(box.safety().robotMode());
    boxV = meter.boxV();
    if (!robotPowered) {
      return;
    }
    robotV = meter.robotV();
    for (int i = 0; i < Joints.COUNT; i++) {
      jointV[i] = meter.jointV(i, sensors.currentA(i));
    }
  }

  /** Whether the arm rests, as {@link ArmState#rests}. */
  public boolean rests() {
    return ArmState.rests(steady, controlMode, sensors.fastestRadPerS());
  }

  /** The state of the arm. */
  public ArmState state() {
    return new ArmState(
        targetPositionRad.joints(),
        targetSpeedRadPerS.joints(),
        targetAccelerationRadPerS2.joints(),
        actualPositionRad.joints(),
        sensors.speedRadPerS(),
        tool,
        description,
        kinematics,
        controlMode,
        moving,
        steady,
        speedFraction,
        speedScaling,
        fault);
  }

  /** The readings of the arm. */
  public ArmReadings readings() {
    return new ArmReadings(
        sensors.accelerationRadPerS2(),
        sensors.torqueNm(),
        sensors.externalTorqueNm(),
        sensors.targetTorqueNm(),
        sensors.currentA(),
        sensors.targetCurrentA(),
        sensors.temperatureC(),
        sensors.toolTemperatureC(),
        WarmUp.CONTROL_BOX.temperatureC(timeS),
        toolCurrentA,
        new ArmReadings.Acceleration(
            sensors.toolAccelerationMPerS2(0),
            sensors.toolAccelerationMPerS2(1),
            sensors.toolAccelerationMPerS2(2)),
        flangeWrenchInBase.wrench(),
        rawFlangeWrench.wrench(),
        payload,
        mounting,
        robotPowered
            ? new SupplyVoltages(boxV, robotV, Joints.of(jointV))
            : new SupplyVoltages(boxV, 0, Joints.ZERO),
        robotCurrentA,
        energyConsumedJ,
        energyDissipatedJ,
        momentumKgMPerS,
        deviationRatio,
        collisionRatio);
  }
}
