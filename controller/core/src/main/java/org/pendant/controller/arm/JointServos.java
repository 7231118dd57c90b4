package org.pendant.controller.arm;

import java.util.Arrays;
import java.util.SplittableRandom;
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
 * <p>What they follow is the target as it was a moment before, half a millisecond on most arms:
 * that is how far real drives lag.
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
  private static final double CLOSE_ENOUGH_RAD = 3e-5;

  /**
   * Up to this difference from the mean of the target's accelerations the load is interpolated,
   * rad/s²: less than a joint could feel.
   */
  private static final double EVEN_RAD_PER_S2 = 0.02;

  /** How far the demanded speed may exceed a joint's largest one, as a factor. */
  private static final double SPEED_MARGIN = 1.1;

  /**
   * The least dry friction, Nm: too little to be noticed, enough for a drive without friction to
   * come to rest for good.
   */
  private static final double MIN_FRICTION_NM = 1e-6;

  private static final int N = Joints.COUNT;

  private final ArmDynamics model;
  private final Actuator[] actuators;
  private final JointFriction own;
  private final HeldFriction held;
  private final TargetLoad load;
  private final double[] lagS = new double[N];

  /** What the lags are of a frame. */
  private final double[] lagShare = new double[N];

  private final double[] damping = new double[N];
  private final double[] fastest = new double[N];
  private final double[] limitNm = new double[N];

  /** Feed-forward, Nm: the torque that what is followed needs in the middle of the frame. */
  private final double[] feedNm = new double[N];

  private final double[] lastMomentNm = new double[N];
  private final double[] lastSpeedDependentNm = new double[N];
  private final double[] lastQdd = new double[N];
  private final double[] givenQ = new double[N];
  private final double[] givenQd = new double[N];
  private final double[] lastQd = new double[N];

  /** Where what is followed is when the frame begins, rad; after that, where when it ends. */
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

  /**
   * Servos that follow nothing yet.
   *
   * @param own friction of the true joints
   * @param random draws what dry friction holds back at each stop
   */
  JointServos(ArmDescription arm, ArmDynamics model, JointFriction own, SplittableRandom random) {
    this.model = model;
    this.own = own;
    held = new HeldFriction(random);
    load = new TargetLoad(arm, model);
    actuators = arm.actuators().toArray(Actuator[]::new);
    DMatrixRMaj heaviest = heaviest(arm);
    for (int i = 0; i < N; i++) {
      lagS[i] = actuators[i].lagS();
      lagShare[i] = lagS[i] / FrameTime.FRAME_S;
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
    System.arraycopy(toQ, 0, fromQ, 0, N);
    System.arraycopy(toQd, 0, fromQd, 0, N);
    System.arraycopy(givenQd, 0, lastQd, 0, N);
    System.arraycopy(load.momentNm, 0, lastMomentNm, 0, N);
    System.arraycopy(load.speedDependentNm, 0, lastSpeedDependentNm, 0, N);
    System.arraycopy(load.qdd, 0, lastQdd, 0, N);
    target.positionRad().copyTo(givenQ);
    target.speedRadPerS().copyTo(givenQd);
    load.of(target);
    own.underLoad(load.momentNm);
    boolean begins = !following;
    if (begins) {
      begin();
    }
    for (int i = 0; i < N; i++) {
      toQd[i] = givenQd[i] - lagShare[i] * (givenQd[i] - lastQd[i]);
      toQ[i] = givenQ[i] - lagS[i] * (toQd[i] + givenQd[i]) / 2;
    }
    settled =
        Arrays.equals(fromQ, toQ)
            && Arrays.equals(fromQd, toQd)
            && Arrays.equals(lastMomentNm, load.momentNm);
    feedForward(begins);
  }

  /** Takes the target to have moved evenly so far. */
  private void begin() {
    for (int i = 0; i < N; i++) {
      double beforeS = FrameTime.FRAME_S + lagS[i];
      lastQd[i] = givenQd[i] - FrameTime.FRAME_S * load.qdd[i];
      fromQd[i] = givenQd[i] - beforeS * load.qdd[i];
      fromQ[i] = givenQ[i] - beforeS * (fromQd[i] + givenQd[i]) / 2;
    }
    Arrays.fill(integralNm, 0);
    held.release();
    following = true;
  }

  private void feedForward(boolean begins) {
    boolean even = !begins;
    for (int i = 0; i < N; i++) {
      middleQ[i] = (fromQ[i] + toQ[i]) / 2;
      middleQd[i] = (fromQd[i] + toQd[i]) / 2;
      meanQdd[i] = (toQd[i] - fromQd[i]) / FrameTime.FRAME_S;
      double expected = meanBetween(i, lastQdd[i], load.qdd[i]);
      even &= Math.abs(meanQdd[i] - expected) <= EVEN_RAD_PER_S2;
    }
    if (!even) {
      model.inverse(middleQ, middleQd, meanQdd, feedNm);
    }
    for (int i = 0; i < N; i++) {
      Actuator actuator = actuators[i];
      double speedDependentNm;
      if (even) {
        feedNm[i] = meanBetween(i, lastMomentNm[i], load.momentNm[i]);
        speedDependentNm = middleBetween(i, lastSpeedDependentNm[i], load.speedDependentNm[i]);
      } else {
        feedNm[i] += actuator.rotorInertiaKgM2() * meanQdd[i];
        speedDependentNm = actuator.speedDependentNmSPerRad(middleQd[i]) * middleQd[i];
      }
      feedNm[i] += own.dryNm[i] * held.share(i, middleQd[i]) + speedDependentNm;
    }
  }

  /** The value in the middle of what joint {@code i} follows in this frame, from those at ends. */
  private double middleBetween(int i, double last, double now) {
    return last + (0.5 - lagShare[i]) * (now - last);
  }

  /** The mean in what joint {@code i} follows in this frame, from means of the target's frames. */
  private double meanBetween(int i, double last, double now) {
    return last + (1 - lagShare[i]) * (now - last);
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
      step.driveNm[i] = feedNm[i] + integralNm[i] + damping[i] * allowed;
      step.slopeNmSPerRad[i] =
          atFullSpeed[i] ? damping[i] : damping[i] * (1 + POSITION_RATE_PER_S * half);
      step.limitNm[i] = limitNm[i];
      step.coulombNm[i] = Math.max(MIN_FRICTION_NM, own.dryNm[i]);
      step.viscousNmSPerRad[i] = own.speedDependentNmSPerRad[i];
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
  public void publishTarget(SimulatedSensors sensors) {
    load.publish(sensors);
  }

  @Override
  public boolean settled() {
    return settled;
  }
}
