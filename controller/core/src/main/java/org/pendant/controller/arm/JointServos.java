package org.pendant.controller.arm;

import java.util.Arrays;
import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.pendant.models.arm.Actuator;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.time.FrameTime;

/**
 * Joint servos that follow a setpoint. The torque that the target motion needs by the controller's
 * model is fed forward; each joint corrects what is left by itself: its distance from the target
 * demands a speed, the error of the speed a torque, and what stays is integrated away. The servos
 * of a real arm run many times a frame, so they are taken to act on the state at the end of a step.
 *
 * <p>Gains are laid out, as on a real arm, for the largest inertia that a joint has to turn: the
 * arm stretched out, with its rated payload.
 */
final class JointServos implements Drives {
  /** How fast the position loops are, 1/s: a distance of 1 rad demands this speed in rad/s. */
  private static final double POSITION_RATE_PER_S = 40;

  /** How fast the speed loops are at the largest inertia, 1/s. */
  private static final double SPEED_RATE_PER_S = 160;

  /** How fast the rest is integrated away, 1/s. */
  private static final double INTEGRATION_RATE_PER_S = 8;

  /** Nothing is integrated nearer than this to the target, rad: ends the hunt for the last bit. */
  private static final double CLOSE_ENOUGH_RAD = 5e-5;

  /** How far the demanded speed may exceed a joint's largest one, as a factor. */
  private static final double SPEED_MARGIN = 1.1;

  /** Friction is fed forward in full above this target speed, rad/s. */
  private static final double SLIDING_RAD_PER_S = 1e-4;

  /**
   * The least dry friction, Nm: too little to be noticed, enough for a drive without friction to
   * come to rest for good.
   */
  private static final double MIN_FRICTION_NM = 1e-6;

  private static final int N = Joints.COUNT;

  private final ArmDynamics model;
  private final List<Actuator> actuators;
  private final double[] frictionNm = new double[N];
  private final double[] viscousNmSPerRad = new double[N];
  private final double[] damping = new double[N];
  private final double[] fastest = new double[N];
  private final double[] limitNm = new double[N];

  /** Feed-forward, Nm: the torque that the target needs in the middle of the frame. */
  private final double[] targetNm = new double[N];

  private final double[] fromQ = new double[N];
  private final double[] fromQd = new double[N];
  private final double[] toQ = new double[N];
  private final double[] toQd = new double[N];
  private final double[] middleQ = new double[N];
  private final double[] middleQd = new double[N];
  private final double[] meanQdd = new double[N];
  private final double[] integralNm = new double[N];
  private final boolean[] atFullSpeed = new boolean[N];
  private boolean following;
  private boolean settled;

  JointServos(ArmDescription arm, ArmDynamics model) {
    this.model = model;
    actuators = arm.actuators();
    DMatrixRMaj heaviest = heaviest(arm);
    for (int i = 0; i < N; i++) {
      Actuator actuator = actuators.get(i);
      frictionNm[i] = Math.max(MIN_FRICTION_NM, actuator.coulombNm());
      viscousNmSPerRad[i] = actuator.viscousNmSPerRad();
      damping[i] = SPEED_RATE_PER_S * heaviest.get(i, i);
      fastest[i] = SPEED_MARGIN * arm.joints().get(i).maxSpeedRadPerS();
      limitNm[i] = arm.joints().get(i).maxTorqueNm();
    }
  }

  /** The mass matrix of the arm stretched out, its rated payload a hand's breadth away. */
  private static DMatrixRMaj heaviest(ArmDescription arm) {
    ArmDynamics dynamics = new ArmDynamics(arm);
    dynamics.setPayload(Payload.of(arm.payloadKg(), 0, 0, 0.1));
    DMatrixRMaj mass = new DMatrixRMaj(N, N);
    dynamics.mass(new double[N], true, mass);
    return mass;
  }

  /** Forgets what was followed before: the next target is taken as it comes. */
  void release() {
    following = false;
  }

  /** Takes the target of a frame. */
  void follow(ArmCommand.Servo target) {
    if (following) {
      System.arraycopy(toQ, 0, fromQ, 0, N);
      System.arraycopy(toQd, 0, fromQd, 0, N);
    }
    target.positionRad().copyTo(toQ);
    target.speedRadPerS().copyTo(toQd);
    if (!following) {
      begin(target.accelerationRadPerS2());
    }
    settled = Arrays.equals(fromQ, toQ) && Arrays.equals(fromQd, toQd);
    feedForward();
  }

  /** Takes the target to have moved evenly so far. */
  private void begin(Joints accelerationRadPerS2) {
    for (int i = 0; i < N; i++) {
      fromQd[i] = toQd[i] - FrameTime.FRAME_S * accelerationRadPerS2.get(i);
      fromQ[i] = toQ[i] - FrameTime.FRAME_S * (fromQd[i] + toQd[i]) / 2;
    }
    Arrays.fill(integralNm, 0);
    following = true;
  }

  private void feedForward() {
    for (int i = 0; i < N; i++) {
      middleQ[i] = (fromQ[i] + toQ[i]) / 2;
      middleQd[i] = (fromQd[i] + toQd[i]) / 2;
      meanQdd[i] = (toQd[i] - fromQd[i]) / FrameTime.FRAME_S;
    }
    model.inverse(middleQ, middleQd, meanQdd, targetNm);
    for (int i = 0; i < N; i++) {
      double sliding = Math.max(-1, Math.min(1, middleQd[i] / SLIDING_RAD_PER_S));
      targetNm[i] +=
          actuators.get(i).rotorInertiaKgM2() * meanQdd[i]
              + actuators.get(i).coulombNm() * sliding
              + viscousNmSPerRad[i] * middleQd[i];
    }
  }

  @Override
  public void prepare(double remainingS, double stepS, ArmBody body, JointStep step) {
    double half = stepS / 2;
    for (int i = 0; i < N; i++) {
      double ownShare = body.q[i] + half * body.qd[i];
      double demand =
          targetQd(i, remainingS) + POSITION_RATE_PER_S * (targetQ(i, remainingS) - ownShare);
      double allowed = Math.max(-fastest[i], Math.min(fastest[i], demand));
      atFullSpeed[i] = allowed != demand;
      step.driveNm[i] = targetNm[i] + integralNm[i] + damping[i] * allowed;
      step.slopeNmSPerRad[i] =
          atFullSpeed[i] ? damping[i] : damping[i] * (1 + POSITION_RATE_PER_S * half);
      step.limitNm[i] = limitNm[i];
      step.coulombNm[i] = frictionNm[i];
      step.viscousNmSPerRad[i] = viscousNmSPerRad[i];
    }
  }

  @Override
  public void stepped(double remainingS, double stepS, ArmBody body, JointStep step) {
    for (int i = 0; i < N; i++) {
      double error = targetQ(i, remainingS) - body.q[i];
      if (Math.abs(error) > CLOSE_ENOUGH_RAD && !atFullSpeed[i] && step.limited[i] == 0) {
        double gain = damping[i] * POSITION_RATE_PER_S * INTEGRATION_RATE_PER_S;
        double sum = integralNm[i] + stepS * gain * error;
        integralNm[i] = Math.max(-limitNm[i], Math.min(limitNm[i], sum));
        settled = false;
      }
    }
  }

  private double targetQd(int i, double remainingS) {
    return toQd[i] - remainingS / FrameTime.FRAME_S * (toQd[i] - fromQd[i]);
  }

  private double targetQ(int i, double remainingS) {
    return toQ[i] - remainingS * (targetQd(i, remainingS) + toQd[i]) / 2;
  }

  @Override
  public double targetNm(int joint) {
    return targetNm[joint];
  }

  @Override
  public boolean settled() {
    return settled;
  }
}
