package org.pendant.controller.world;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.pendant.cell.BodyHold;
import org.pendant.cell.RigidBodyWorld;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Gripper: what grips bodies of a scene, at the flange. {@link ParallelGripper} has fingers, {@link
 * VacuumGripper} a vacuum cup. What it holds goes with the flange as far as friction and force
 * allow, and is felt there.
 */
public abstract sealed class Gripper permits ParallelGripper, VacuumGripper {
  private final GripperSetup setup;
  final RigidBodyWorld bodies;
  final FreeBodies among;
  final ArmBodies arm;

  /** Its frame and speed, in the base. */
  final double[] frame12 = new double[Transforms.SIZE];

  final double[] twist6 = new double[6];
  final List<BodyHold> holds = new ArrayList<>();
  private final double[] inFlange12 = new double[Transforms.SIZE];
  private final double[] wrench6 = new double[6];
  private boolean placed;

  Gripper(GripperSetup setup, ArmBodies arm, FreeBodies among) {
    this.setup = setup;
    this.arm = arm;
    this.among = among;
    bodies = among.bodies();
  }

  /** The flange is there at the end of the step, and moves so. */
  void place(double[] flange12, Pose tcpInFlange, double[] flangeTwist6) {
    Transforms.of(setup.atInFlange().orElse(tcpInFlange), inFlange12);
    Transforms.multiply(flange12, inFlange12, frame12);
    double armX = frame12[9] - flange12[9];
    double armY = frame12[10] - flange12[10];
    double armZ = frame12[11] - flange12[11];
    System.arraycopy(flangeTwist6, 0, twist6, 0, 6);
    twist6[0] += flangeTwist6[4] * armZ - flangeTwist6[5] * armY;
    twist6[1] += flangeTwist6[5] * armX - flangeTwist6[3] * armZ;
    twist6[2] += flangeTwist6[3] * armY - flangeTwist6[4] * armX;
    placed = true;
    for (BodyHold hold : holds) {
      hold.move(frame12, twist6);
    }
    moved();
  }

  /** Its frame has moved. */
  void moved() {}

  /** Adds what it feels of the bodies that it holds: force and torque on the flange's origin. */
  void addWrench(double[] flange12, double[] felt6) {
    for (int i = 0; i < holds.size(); i++) {
      holds.get(i).wrench(wrench6);
      add(wrench6, frame12, flange12, felt6);
    }
  }

  /** Adds a wrench about the origin of one frame to one about another's. */
  static void add(double[] wrench6, double[] from12, double[] flange12, double[] felt6) {
    double armX = from12[9] - flange12[9];
    double armY = from12[10] - flange12[10];
    double armZ = from12[11] - flange12[11];
    for (int k = 0; k < 6; k++) {
      felt6[k] += wrench6[k];
    }
    felt6[3] += armY * wrench6[2] - armZ * wrench6[1];
    felt6[4] += armZ * wrench6[0] - armX * wrench6[2];
    felt6[5] += armX * wrench6[1] - armY * wrench6[0];
  }

  /** Whether it has to be reckoned with even where nothing else moves. */
  boolean busy() {
    return !holds.isEmpty();
  }

  /** Whether it is known where it is: not before the first frame. */
  final boolean placed() {
    return placed;
  }

  /** Whether it holds a body. */
  public final boolean holds() {
    return !holds.isEmpty();
  }

  /** Lets everything go. */
  public final void release() {
    for (BodyHold hold : holds) {
      bodies.release(hold);
    }
    holds.clear();
  }

  final GripperSetup setup() {
    return setup;
  }

  /** Coefficient of friction between it and a body. */
  final double frictionWith(int body) {
    return Math.sqrt(setup.friction() * among.friction(body));
  }

  /** Column {@code axis} of its frame: a direction in the base. */
  final double[] axis(int axis) {
    return new double[] {frame12[axis], frame12[3 + axis], frame12[6 + axis]};
  }

  /** A place of its frame, in the base. */
  final double[] at(double x, double y, double z) {
    double[] place = new double[3];
    for (int row = 0; row < 3; row++) {
      place[row] =
          frame12[9 + row]
              + frame12[3 * row] * x
              + frame12[3 * row + 1] * y
              + frame12[3 * row + 2] * z;
    }
    return place;
  }

  static double[] minus(double[] vector) {
    return Arrays.stream(vector).map(each -> -each).toArray();
  }
}
