package org.pendant.controller.arm;

import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.world.ContactWorld;
import org.pendant.controller.world.Scene;
import org.pendant.models.arm.Actuator;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.time.FrameTime;

/** A simulated arm with everything that a test wants to turn. */
final class Rig {
  /** Forearm level, tool down. */
  static final Joints START =
      new Joints(0, -Math.PI / 2, -Math.PI / 2, -Math.PI / 2, Math.PI / 2, 0);

  /** Somewhere else; the joints turn by different angles to get there. */
  static final Joints ELSEWHERE = new Joints(1, -1, -2.2, -0.5, 0.8, 1.5);

  final ArmDescription description;
  final ArmDynamics model;
  final ContactWorld world;
  final DynamicArm arm;

  Rig(String id) {
    this(id, 1);
  }

  Rig(String id, long seed) {
    this(ArmLibrary.load(id), Scene.EMPTY, ReadingNoise.NONE, seed);
  }

  Rig(ArmDescription description, Scene scene) {
    this(description, scene, ReadingNoise.NONE, 1);
  }

  Rig(ArmDescription description, Scene scene, ReadingNoise noise) {
    this(description, scene, noise, 1);
  }

  private Rig(ArmDescription description, Scene scene, ReadingNoise noise, long seed) {
    this.description = description;
    model = new ArmDynamics(description);
    world = new ContactWorld(scene);
    arm = new DynamicArm(new DynamicArm.Setup(description, START, model, world, noise, seed));
  }

  /** The rated payload of an arm, somewhat in front of the flange. */
  static Payload rated(ArmDescription description, double share) {
    return Payload.of(share * description.payloadKg(), 0, 0, 0.1);
  }

  /** The same arm with drives that turn without friction. */
  static ArmDescription frictionless(ArmDescription description) {
    List<Actuator> drives = new ArrayList<>();
    for (Actuator drive : description.actuators()) {
      drives.add(drive.frictionless());
    }
    return description.withActuators(drives);
  }

  /** Hangs one payload on the arm, and lets the controller believe in another one. */
  Rig carrying(Payload load, Payload believed) {
    arm.setLoad(load);
    model.setPayload(believed);
    arm.modelChanged();
    return this;
  }

  static ArmCommand.Servo hold(Joints q) {
    return new ArmCommand.Servo(q, Joints.ZERO, Joints.ZERO);
  }

  void repeat(int frames, ArmCommand command) {
    for (int frame = 0; frame < frames; frame++) {
      arm.step(command);
    }
  }

  /** Holds a position; returns the largest distance from it, rad. */
  double worstWhileHolding(int frames, Joints q) {
    double worst = 0;
    for (int frame = 0; frame < frames; frame++) {
      arm.step(hold(q));
      worst = Math.max(worst, distance(q));
    }
    return worst;
  }

  /** Distance of the joint that is farthest from {@code q}, rad. */
  double distance(Joints q) {
    return arm.positionRad().maxAbsDifference(q);
  }

  /** Frames until the positions have not changed for a second; fails after 20 s. */
  int framesToRest(Joints target) {
    Joints before = arm.positionRad();
    int lastChange = 0;
    for (int frame = 1; frame <= 10_000; frame++) {
      arm.step(hold(target));
      if (!arm.positionRad().equals(before)) {
        lastChange = frame;
        before = arm.positionRad();
      } else if (frame - lastChange > FrameTime.FRAMES_PER_SECOND) {
        return lastChange;
      }
    }
    throw new AssertionError("still moving after 20 s");
  }

  /**
   * A move as movej makes it by default: 1.4 rad/s², 1.05 rad/s at the leading joint. Returns the
   * largest distance of a joint from where a drive is that lags by 0.49 ms, rad.
   */
  double worstWhileMoving(Joints from, Joints to) {
    Trapezoid move = new Trapezoid(from, to, 1.4, 1.05);
    double worst = 0;
    for (int frame = 1; frame <= move.frames(); frame++) {
      ArmCommand.Servo target = move.at(frame);
      arm.step(target);
      for (int i = 0; i < Joints.COUNT; i++) {
        double expected = target.positionRad().get(i) - 0.00049 * target.speedRadPerS().get(i);
        worst = Math.max(worst, Math.abs(arm.positionRad().get(i) - expected));
      }
    }
    return worst;
  }

  /** Kinetic energy of links, load and rotors, J. */
  double kineticEnergyJ(ArmDynamics truth) {
    double[] qd = arm.speedRadPerS().toArray();
    double energy = truth.kineticEnergyJ(arm.positionRad().toArray(), qd);
    for (int i = 0; i < Joints.COUNT; i++) {
      energy += 0.5 * description.actuators().get(i).rotorInertiaKgM2() * qd[i] * qd[i];
    }
    return energy;
  }
}
