package org.pendant.controller.arm;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.pendant.controller.world.ContactWorld;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;
import org.pendant.models.time.FrameTime;

/**
 * Dynamic arm: simulated with masses, friction, drives with limited torque, brakes, and a tool that
 * touches things.
 *
 * <p>The true arm ({@link ArmBody}) is one thing and what the controller believes about it another:
 * the drives reckon with the controller's model and its declared payload, the arm moves by the true
 * load. An arm that rests comes to rest for good: from then on its numbers stay as they are but for
 * the noise of its sensors, and a frame costs next to nothing until something changes.
 *
 * <p>Belongs to the thread of the frame loop.
 */
public final class DynamicArm implements SimulatedArm {
  /** Steps within a frame while the tool touches something: stiff surfaces need short ones. */
  private static final int CONTACT_STEPS = 8;

  /** How hard each joint's brake stops it, rad/s². */
  private static final double BRAKE_RAD_PER_S2 = 30;

  private static final int N = Joints.COUNT;

  /**
   * What an arm is made with.
   *
   * @param arm what it is made of
   * @param startRad where its joints are at first, rad
   * @param model the controller's model; its owner keeps payload and mounting up to date and tells
   *     the arm by {@link #modelChanged}
   * @param world what the tool may touch
   * @param noise of the readings
   * @param seed of the noise
   */
  public record Setup(
      ArmDescription arm,
      Joints startRad,
      ArmDynamics model,
      ContactWorld world,
      ReadingNoise noise,
      long seed) {}

  private final Setup setup;
  private final ArmDynamics truth;
  private final ArmBody body;
  private final JointStep step = new JointStep();
  private final JointFriction friction;
  private final JointServos servos;
  private final FreeMotors freeMotors;
  private final ExternalForces externalForces;
  private final Flange flange;
  private final JointHeat heat;

  /** What the sensors would say without noise. */
  private final SimulatedSensors sensors = new SimulatedSensors();

  private final SensorNoise noise;
  private final double[] motorSum = new double[N];
  private final double[] rotorKgM2 = new double[N];
  private final double[] torqueConstantNmPerA = new double[N];
  private final LastCommand last = new LastCommand();
  private Payload load = Payload.NONE;
  private boolean resting;
  private boolean unmoved;

  /** An arm at rest, with nothing on its flange, upright. */
  public DynamicArm(Setup setup) {
    this.setup = setup;
    ArmDescription arm = setup.arm();
    truth = new ArmDynamics(arm);
    for (int i = 0; i < N; i++) {
      rotorKgM2[i] = arm.actuators().get(i).rotorInertiaKgM2();
      torqueConstantNmPerA[i] = arm.actuators().get(i).torqueConstantNmPerA();
    }
    body = new ArmBody(truth, setup.startRad());
    friction = new JointFriction(arm);
    servos =
        new JointServos(arm, setup.model(), friction, new SplittableRandom(setup.seed()).split());
    freeMotors = new FreeMotors(arm, setup.model(), friction);
    externalForces = new ExternalForces(arm, setup.world());
    flange = new Flange(arm, sensors.angles);
    heat = new JointHeat(arm, sensors, setup.noise().measured());
    noise = new SensorNoise(arm, setup.noise(), setup.seed(), sensors);
    flange.update(body.q, body.qd, body.qdd);
    measureMotion();
    noise.read(sensors, false);
  }

  @Override
  public void step(ArmCommand command) {
    unmoved = resting && !externalForces.changed() && last.is(command);
    if (!unmoved) {
      move(command);
      last.remember(command);
    }
    heat.step(sensors);
    noise.read(sensors, !(command instanceof ArmCommand.BrakesOn));
  }

  @Override
  public void place() {
    externalForces.place(body.q, body.qd);
  }

  private void move(ArmCommand command) {
    body.beginFrame();
    switch (command) {
      case ArmCommand.BrakesOn brakes -> brake();
      case ArmCommand.Servo target -> {
        servos.follow(target);
        drive(servos);
      }
      case ArmCommand.Torque torques -> {
        servos.release();
        freeMotors.add(torques);
        drive(freeMotors);
      }
      case ArmCommand.Guide guided -> {
        servos.release();
        freeMotors.guide(guided);
        drive(freeMotors);
      }
    }
  }

  private void brake() {
    servos.release();
    externalForces.lookAhead(body);
    body.brake(BRAKE_RAD_PER_S2);
    body.endFrame();
    flange.update(body.q, body.qd, body.qdd);
    Arrays.fill(sensors.torqueNm, 0);
    Arrays.fill(sensors.modelTorqueNm, 0);
    TargetLoad.publishNone(sensors);
    measureMotion();
    measureCurrents();
    heat.load(sensors, false);
    resting = body.still();
  }

  private void drive(Drives drives) {
    body.weigh(step);
    friction.beginFrame(body.qd);
    externalForces.lookAhead(body);
    int steps = externalForces.inContact() ? CONTACT_STEPS : 1;
    double stepS = FrameTime.FRAME_S / steps;
    Arrays.fill(motorSum, 0);
    for (int left = steps - 1; left >= 0; left--) {
      if (steps > 1) {
        externalForces.feel(body, stepS / 2);
      }
      drives.prepare(left * stepS, stepS, body, step);
      body.advance(stepS, externalForces.torqueNm, step);
      drives.stepped(left * stepS, stepS, body, step);
      for (int i = 0; i < N; i++) {
        motorSum[i] += step.motorNm[i];
      }
    }
    body.endFrame();
    flange.update(body.q, body.qd, body.qdd);
    measureMotion();
    measureTorques(drives, steps);
    measureCurrents();
    heat.load(sensors, true);
    resting = body.still() && drives.settled();
  }

  private void measureMotion() {
    System.arraycopy(body.q, 0, sensors.positionRad, 0, N);
    System.arraycopy(body.qd, 0, sensors.speedRadPerS, 0, N);
    System.arraycopy(body.qdd, 0, sensors.accelerationRadPerS2, 0, N);
    flange.accelerometer(sensors.toolAccelerationMPerS2);
  }

  private void measureTorques(Drives drives, int steps) {
    setup.model().inverse(body.middleQ, body.middleQd, body.qdd, sensors.modelTorqueNm);
    for (int i = 0; i < N; i++) {
      sensors.torqueNm[i] = motorSum[i] / steps;
      sensors.modelTorqueNm[i] +=
          rotorKgM2[i] * body.qdd[i] + friction.slidingNm(i, body.middleQd[i]);
    }
    drives.publishTarget(sensors);
  }

  private void measureCurrents() {
    for (int i = 0; i < N; i++) {
      sensors.currentA[i] = sensors.torqueNm[i] / torqueConstantNmPerA[i];
    }
  }

  @Override
  public void jumpTo(Joints positionRad) {
    jumpTo(positionRad, Joints.ZERO);
  }

  /** As {@link #jumpTo(Joints)}, with joint speeds in rad/s. */
  void jumpTo(Joints positionRad, Joints speedRadPerS) {
    body.jumpTo(positionRad);
    speedRadPerS.copyTo(body.qd);
    servos.release();
    flange.update(body.q, body.qd, body.qdd);
    measureMotion();
    noise.read(sensors, false);
    resting = false;
  }

  @Override
  public SimulatedSensors sensors() {
    return noise.readings();
  }

  @Override
  public boolean rests() {
    return unmoved && noise.errs() && noise.settled();
  }

  @Override
  public void copyLoadOnFlange(double[] load6) {
    flange.loadOf(load, externalForces.wrench6, load6);
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
    truth.setPayload(load);
    resting = false;
  }

  @Override
  public void setMounting(double x, double y, double z) {
    truth.setGravity(x, y, z);
    externalForces.setMounting(x, y, z);
    flange.mount(x, y, z);
    flange.update(body.q, body.qd, body.qdd);
    flange.accelerometer(sensors.toolAccelerationMPerS2);
    resting = false;
  }

  @Override
  public void setToolCentre(Pose tcpInFlange) {
    externalForces.setToolCentre(tcpInFlange);
    resting = false;
  }

  @Override
  public void modelChanged() {
    resting = false;
  }
}
