package org.pendant.controller.state;

import java.util.List;
import org.pendant.controller.box.Mounting;
import org.pendant.models.arm.Joints;
import org.pendant.models.arm.LinkMass;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;
import org.pendant.models.pose.Wrench;

/** Arm forces that are not measured but computed from joints and masses. */
final class ArmForces {
  /** Keeps the wrench moderate near singularities, where the joints do not feel all of it. */
  private static final double DAMPING = 0.01;

  private static final int N = Joints.COUNT;

  private ArmForces() {}

  /** The wrench on the flange whose joint torques balance the surplus of the motors. */
  static Wrench flangeWrenchOf(ArmState arm, Joints surplusNm) {
    if (surplusNm.equals(Joints.ZERO)) {
      return Wrench.ZERO;
    }
    Jacobian jacobian = new Jacobian(arm.description());
    double[] matrix = new double[Jacobian.SIZE];
    jacobian.at(arm.actualPositionRad().toArray(), Pose.ZERO, matrix);
    double[] transposed = new double[Jacobian.SIZE];
    double[] balance = new double[N];
    for (int row = 0; row < N; row++) {
      balance[row] = -surplusNm.get(row);
      for (int i = 0; i < N; i++) {
        transposed[N * row + i] = matrix[N * i + row];
      }
    }
    double[] w = new double[N];
    jacobian.solveDamped(transposed, balance, DAMPING, w);
    return new Wrench(w[0], w[1], w[2], w[3], w[4], w[5]);
  }

  /**
   * The sum of what all links and the payload need for weight and acceleration, by Newton's and
   * Euler's equations about the origin of the base.
   */
  static Wrench baseWrench(ArmState arm, Payload payload, Mounting mounting) {
    double[][] frames = new double[N][Transforms.SIZE];
    arm.kinematics().frames(arm.targetPositionRad().toArray(), frames);
    LinkMotion motion = new LinkMotion();
    // an arm in an accelerated frame is as one that is accelerated the other way
    motion.a[0] = mounting.gravityXMPerS2() + mounting.accelerationXMPerS2();
    motion.a[1] = mounting.gravityYMPerS2() + mounting.accelerationYMPerS2();
    motion.a[2] = mounting.gravityZMPerS2() + mounting.accelerationZMPerS2();
    double[] sum = new double[N];
    List<LinkMass> links = arm.description().links();
    for (int i = 0; i < N; i++) {
      LinkMass link = links.get(i);
      motion.turn(
          i, frames, arm.targetSpeedRadPerS().get(i), arm.targetAccelerationRadPerS2().get(i));
      motion.goTo(frames[i], link.comXM(), link.comYM(), link.comZM());
      addForce(motion, link.massKg(), sum);
      addTurning(
          motion,
          frames[i],
          new double[] {
            link.ixx(), link.ixy(), link.ixz(),
            link.ixy(), link.iyy(), link.iyz(),
            link.ixz(), link.iyz(), link.izz()
          },
          sum);
      motion.goTo(frames[i][9], frames[i][10], frames[i][11]);
    }
    motion.goTo(frames[N - 1], payload.cogXM(), payload.cogYM(), payload.cogZM());
    addForce(motion, payload.massKg(), sum);
    addTurning(
        motion,
        frames[N - 1],
        new double[] {
          payload.ixx(), payload.ixy(), payload.ixz(),
          payload.ixy(), payload.iyy(), payload.iyz(),
          payload.ixz(), payload.iyz(), payload.izz()
        },
        sum);
    return new Wrench(sum[0], sum[1], sum[2], sum[3], sum[4], sum[5]);
  }

  private static void addForce(LinkMotion at, double massKg, double[] sum) {
    double[] moment = new double[3];
    LinkMotion.cross(at.p, massKg * at.a[0], massKg * at.a[1], massKg * at.a[2], moment);
    for (int axis = 0; axis < 3; axis++) {
      sum[axis] += massKg * at.a[axis];
      sum[3 + axis] += moment[axis];
    }
  }

  /** Adds {@code I alpha + w x I w} for an inertia along the axes of a link. */
  private static void addTurning(LinkMotion at, double[] frame, double[] inertia9, double[] sum) {
    double[] momentum = turned(frame, inertia9, at.w);
    double[] change = turned(frame, inertia9, at.alpha);
    double[] gyro = new double[3];
    LinkMotion.cross(at.w, momentum[0], momentum[1], momentum[2], gyro);
    for (int axis = 0; axis < 3; axis++) {
      sum[3 + axis] += change[axis] + gyro[axis];
    }
  }

  /** {@code R I R^T u}. */
  private static double[] turned(double[] frame, double[] inertia9, double[] u) {
    double[] inLink = new double[3];
    for (int i = 0; i < 3; i++) {
      inLink[i] = frame[i] * u[0] + frame[3 + i] * u[1] + frame[6 + i] * u[2];
    }
    double[] product = new double[3];
    for (int i = 0; i < 3; i++) {
      product[i] =
          inertia9[3 * i] * inLink[0]
              + inertia9[3 * i + 1] * inLink[1]
              + inertia9[3 * i + 2] * inLink[2];
    }
    double[] inBase = new double[3];
    for (int i = 0; i < 3; i++) {
      inBase[i] =
          frame[3 * i] * product[0] + frame[3 * i + 1] * product[1] + frame[3 * i + 2] * product[2];
    }
    return inBase;
  }
}
