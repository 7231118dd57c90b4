package org.pendant.controller.arm;

import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.time.FrameTime;

/**
 * Arm body: the moving masses of the true arm: where the joints are, how fast they turn, and how
 * both change under torques.
 *
 * <p>Mass matrix, weight and Coriolis torques are taken once a frame, where the arm will be in its
 * middle, which makes the steps exact to the second order of their length. Within a frame the joint
 * speeds change evenly.
 */
final class ArmBody {
  private static final int N = Joints.COUNT;
  private static final double[] ZERO = new double[N];

  /** Positions, rad. */
  final double[] q = new double[N];

  /** Speeds, rad/s. */
  final double[] qd = new double[N];

  /** Mean accelerations of the last frame, rad/s². */
  final double[] qdd = new double[N];

  /** Positions in the middle of the last frame, rad. */
  final double[] middleQ = new double[N];

  /** Speeds in the middle of the last frame, rad/s. */
  final double[] middleQd = new double[N];

  private final ArmDynamics dynamics;
  private final double[] bias = new double[N];
  private final double[] startQ = new double[N];
  private final double[] startQd = new double[N];

  ArmBody(ArmDynamics dynamics, Joints startRad) {
    this.dynamics = dynamics;
    jumpTo(startRad);
  }

  /** Puts the joints elsewhere, at rest. */
  void jumpTo(Joints positionRad) {
    for (int i = 0; i < N; i++) {
      q[i] = positionRad.get(i);
      qd[i] = 0;
    }
    beginFrame();
    endFrame();
  }

  /** Remembers where the frame begins. */
  void beginFrame() {
    System.arraycopy(q, 0, startQ, 0, N);
    System.arraycopy(qd, 0, startQd, 0, N);
  }

  /** Writes the mass matrix of the frame that begins. */
  void weigh(JointStep step) {
    double half = FrameTime.FRAME_S / 2;
    for (int i = 0; i < N; i++) {
      middleQ[i] = q[i] + half * qd[i];
      middleQd[i] = qd[i] + half * qdd[i];
    }
    dynamics.mass(middleQ, true, step.massKgM2);
    dynamics.inverse(middleQ, middleQd, ZERO, bias);
  }

  /**
   * Moves the joints by a step.
   *
   * @param outsideNm joint torques of what pushes from outside, Nm
   */
  void advance(double stepS, double[] outsideNm, JointStep step) {
    for (int i = 0; i < N; i++) {
      step.freeNm[i] = outsideNm[i] - bias[i];
      q[i] += stepS / 2 * qd[i];
    }
    step.solve(stepS, qd);
    for (int i = 0; i < N; i++) {
      q[i] += stepS / 2 * qd[i];
    }
  }

  /** Slows every joint for a frame as its own brake does, whatever else acts on it, to rest. */
  void brake(double decelerationRadPerS2) {
    for (int i = 0; i < N; i++) {
      double speed = Math.abs(qd[i]);
      double left = Math.max(0, speed - decelerationRadPerS2 * FrameTime.FRAME_S);
      double timeS = (speed - left) / decelerationRadPerS2;
      q[i] += Math.signum(qd[i]) * timeS * (speed + left) / 2;
      qd[i] = left == 0 ? 0 : Math.copySign(left, qd[i]);
    }
  }

  /** Takes the means of the frame that ends. */
  void endFrame() {
    for (int i = 0; i < N; i++) {
      middleQ[i] = (startQ[i] + q[i]) / 2;
      middleQd[i] = (startQd[i] + qd[i]) / 2;
      qdd[i] = (qd[i] - startQd[i]) / FrameTime.FRAME_S;
    }
  }

  /** Whether no joint has moved in the frame that ended, nor moves now. */
  boolean still() {
    for (int i = 0; i < N; i++) {
      if (startQd[i] != 0 || qd[i] != 0) {
        return false;
      }
    }
    return true;
  }
}
