package org.pendant.controller.arm;

import java.util.Arrays;
import java.util.Optional;
import org.pendant.controller.world.ContactWorld;
import org.pendant.controller.world.Scene;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.JointNumbers;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;

/**
 * Ideal arm: simulated without mass, friction or delay, it is always exactly where it should be.
 * Its motors feel nothing, nothing stops it, and without a target it stays where it is, at once. It
 * pushes and carries the bodies of a scene, as a kinematic body does, and they do not move it.
 *
 * <p>Only the flange feels something: the weight and inertia of the load in the target motion, and
 * what bodies do to the tool; and the controller says what that motion would need, as with any arm.
 *
 * <p>Guided by hand, driven by torques or pushed in backdrive it has no target, and something must
 * yield: it then moves as the {@link DynamicArm} would.
 */
public final class IdealArm implements SimulatedArm {
  private final DynamicArm.Setup setup;
  private final Flange flange;
  private final TargetLoad targetLoad;
  private final ExternalForces externalForces;
  private final SimulatedSensors sensors = new SimulatedSensors();
  private Optional<DynamicArm> yielding = Optional.empty();
  private Payload load = Payload.NONE;
  private Pose tcpInFlange = Pose.ZERO;
  private double[] mounting3 = {0, 0, ArmDynamics.STANDARD_GRAVITY_M_PER_S2};
  private final JointNumbers positionRad = new JointNumbers();
  private final JointNumbers speedRadPerS = new JointNumbers();
  private final LastCommand last = new LastCommand();

  /** Whether it has moved since bodies were told where it is. */
  private boolean moved;

  /**
   * An arm at rest that nothing ever touches.
   *
   * @param arm what it is made of
   * @param startRad where its joints are at first, rad
   */
  public IdealArm(ArmDescription arm, Joints startRad) {
    this(
        new DynamicArm.Setup(
            arm,
            startRad,
            new ArmDynamics(arm),
            new ContactWorld(Scene.EMPTY),
            ReadingNoise.NONE,
            0));
  }

  /** An arm at rest; model and world count when it yields, the noise never. */
  public IdealArm(DynamicArm.Setup setup) {
    this.setup =
        new DynamicArm.Setup(
            setup.arm(),
            setup.startRad(),
            setup.model(),
            setup.world(),
            ReadingNoise.NONE,
            setup.seed());
    flange = new Flange(setup.arm(), sensors.angles);
    targetLoad = new TargetLoad(setup.arm(), setup.model());
    externalForces = new ExternalForces(setup.arm(), setup.world());
    Arrays.fill(sensors.temperatureC, JointHeat.AMBIENT_C);
    sensors.toolTemperatureC = JointHeat.AMBIENT_C;
    move(setup.startRad(), Joints.ZERO, Joints.ZERO);
  }

  @Override
  public void step(ArmCommand command) {
    if (yields(command)) {
      yieldTo(command, yields(last.command()));
    } else {
      if (!last.is(command)) {
        obey(command);
      }
      moveBodies();
    }
    last.remember(command);
  }

  @Override
  public void place() {
    if (yields(last.command())) {
      yielding.ifPresent(DynamicArm::place);
    } else if (setup.world().shared() && mattersToBodies()) {
      moved = false;
      externalForces.place(sensors.positionRad, sensors.speedRadPerS);
    }
  }

  private boolean mattersToBodies() {
    return setup.world().hasFreeBodies() && (moved || setup.world().bodiesMove());
  }

  private void moveBodies() {
    if (!setup.world().shared() && mattersToBodies()) {
      moved = false;
      externalForces.moveBodies(sensors.positionRad, sensors.speedRadPerS);
    }
    externalForces.feelBodies();
  }

  private static boolean yields(ArmCommand command) {
    return command instanceof ArmCommand.Guide || command instanceof ArmCommand.Torque;
  }

  private void obey(ArmCommand command) {
    if (command instanceof ArmCommand.Servo target) {
      positionRad.set(target.positionRad());
      speedRadPerS.set(target.speedRadPerS());
      target.accelerationRadPerS2().copyTo(sensors.accelerationRadPerS2);
      measureMotion();
      publish(target);
    } else {
      TargetLoad.publishNone(sensors);
      move(positionRad.joints(), Joints.ZERO, Joints.ZERO);
    }
  }

  private void yieldTo(ArmCommand command, boolean continues) {
    DynamicArm arm = yielding.orElseGet(this::newYielding);
    yielding = Optional.of(arm);
    if (!continues) {
      arm.jumpTo(positionRad.joints(), speedRadPerS.joints());
    }
    arm.step(command);
    externalForces.feelBodies();
    SimulatedSensors felt = arm.sensors();
    System.arraycopy(felt.targetTorqueNm, 0, sensors.targetTorqueNm, 0, Joints.COUNT);
    sensors.targetCurrent.set(felt.targetCurrent);
    if (!Arrays.equals(felt.positionRad, sensors.positionRad)
        || !Arrays.equals(felt.speedRadPerS, sensors.speedRadPerS)
        || !Arrays.equals(felt.accelerationRadPerS2, sensors.accelerationRadPerS2)) {
      move(felt.positionRad(), felt.speedRadPerS(), felt.accelerationRadPerS2());
    }
  }

  private DynamicArm newYielding() {
    DynamicArm arm = new DynamicArm(setup);
    arm.setLoad(load);
    arm.setToolCentre(tcpInFlange);
    arm.setMounting(mounting3[0], mounting3[1], mounting3[2]);
    return arm;
  }

  @Override
  public void jumpTo(Joints positionRad) {
    last.remember(ArmCommand.BRAKES_ON);
    move(positionRad, Joints.ZERO, Joints.ZERO);
  }

  private void move(Joints position, Joints speed, Joints acceleration) {
    positionRad.set(position);
    speedRadPerS.set(speed);
    acceleration.copyTo(sensors.accelerationRadPerS2);
    measureMotion();
  }

  private void measureMotion() {
    moved = true;
    positionRad.copyTo(sensors.positionRad);
    speedRadPerS.copyTo(sensors.speedRadPerS);
    flange.update(sensors.positionRad, sensors.speedRadPerS, sensors.accelerationRadPerS2);
    flange.accelerometer(sensors.toolAccelerationMPerS2);
  }

  @Override
  public SimulatedSensors sensors() {
    return sensors;
  }

  @Override
  public boolean rests() {
    return false;
  }

  @Override
  public void copyLoadOnFlange(double[] load6) {
    if (setup.world().hasFreeBodies()) {
      flange.loadOf(load, externalForces.wrench6, load6);
    } else {
      flange.weightOf(load, load6);
    }
  }

  @Override
  public void copyWeightOf(Payload payload, double[] load6) {
    flange.weightOf(payload, load6);
  }

  @Override
  public void copyFlangeInBase(double[] flange12) {
    flange.copyInBase(flange12);
  }

  @Override
  public void setLoad(Payload load) {
    this.load = load;
    yielding.ifPresent(arm -> arm.setLoad(load));
  }

  @Override
  public void setMounting(double x, double y, double z) {
    mounting3 = new double[] {x, y, z};
    yielding.ifPresent(arm -> arm.setMounting(x, y, z));
    externalForces.setMounting(x, y, z);
    flange.mount(x, y, z);
    measureMotion();
  }

  @Override
  public void setToolCentre(Pose tcpInFlange) {
    this.tcpInFlange = tcpInFlange;
    externalForces.setToolCentre(tcpInFlange);
    moved = true;
    yielding.ifPresent(arm -> arm.setToolCentre(tcpInFlange));
  }

  @Override
  public void modelChanged() {
    yielding.ifPresent(DynamicArm::modelChanged);
    if (last.command() instanceof ArmCommand.Servo target) {
      publish(target);
    }
  }

  private void publish(ArmCommand.Servo target) {
    targetLoad.of(target);
    targetLoad.publish(sensors);
  }

  @Override
  public Joints positionRad() {
    return positionRad.joints();
  }

  @Override
  public Joints speedRadPerS() {
    return speedRadPerS.joints();
  }
}
