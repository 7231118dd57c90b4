package org.pendant.controller.arm;

import org.pendant.models.arm.ArmDescription;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.FlangeMotion;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.JointAngles;
import org.pendant.models.pose.Transforms;

/** Flange: where it is, and what an accelerometer in it and bodies on it feel of its motion. */
final class Flange {
  private final ForwardKinematics forward;
  private final JointAngles angles;
  private final ArmDynamics dynamics;
  private final double[] inBase12 = new double[Transforms.SIZE];

  /**
   * The flange of an arm that stands upright.
   *
   * @param angles shared with others that compute something of the same posture
   */
  Flange(ArmDescription arm, JointAngles angles) {
    this.angles = angles;
    forward = new ForwardKinematics(arm);
    dynamics = new ArmDynamics(arm, angles);
  }

  /**
   * Sets what a resting arm feels along the axes of the base, m/s²; counts from the next update.
   */
  void mount(double x, double y, double z) {
    dynamics.setGravity(x, y, z);
  }

  /** Takes positions (rad), speeds (rad/s) and accelerations (rad/s²) of the joints. */
  void update(double[] q, double[] qd, double[] qdd) {
    dynamics.moveFlange(q, qd, qdd);
    forward.flange(q, angles, inBase12);
  }

  /** Writes the flange in the base frame. */
  void copyInBase(double[] flange12) {
    System.arraycopy(inBase12, 0, flange12, 0, Transforms.SIZE);
  }

  /** Writes what an accelerometer reads along the flange's axes, m/s². */
  void accelerometer(double[] reading) {
    FlangeMotion motion = dynamics.flangeMotion();
    for (int axis = 0; axis < reading.length; axis++) {
      reading[axis] = motion.feltMPerS2(axis);
    }
  }

  /** Writes what {@code payload} weighs in this motion, at the flange's origin along its axes. */
  void weightOf(Payload payload, double[] load6) {
    dynamics.flangeMotion().loadOf(payload, load6);
  }

  /**
   * Writes what {@code payload} weighs and what pushes from outside, at the flange's origin along
   * its axes.
   *
   * @param outside6 at the flange's origin along the base's axes
   */
  void loadOf(Payload payload, double[] outside6, double[] load6) {
    dynamics.flangeMotion().loadOf(payload, load6);
    for (int axis = 0; axis < 3; axis++) {
      load6[axis] += alongOwn(axis, outside6, 0);
      load6[3 + axis] += alongOwn(axis, outside6, 3);
    }
  }

  private double alongOwn(int axis, double[] inBase, int from) {
    return inBase12[axis] * inBase[from]
        + inBase12[3 + axis] * inBase[from + 1]
        + inBase12[6 + axis] * inBase[from + 2];
  }
}
