package org.pendant.controller.safety;

import java.util.Arrays;
import java.util.OptionalInt;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.kinematics.JointAngles;
import org.pendant.models.pose.Pose;

/**
 * Observation: the numbers of one frame and what follows from them. Reused; allocates nothing per
 * frame.
 */
final class Observation {
  final double[] q = new double[Joints.COUNT];
  final double[] qd = new double[Joints.COUNT];
  final double[] targetQ = new double[Joints.COUNT];
  final double[] targetQd = new double[Joints.COUNT];
  final ArmPoints actual;
  final ArmPoints target;

  private final ArmDynamics dynamics;
  private final boolean targetMatters;
  private final double[] lastQ = new double[Joints.COUNT];
  private final double[] lastQd = new double[Joints.COUNT];
  private final double[] momentum = new double[3];
  private Pose lastTcp = Pose.ZERO;
  private double momentumKgMPerS;

  /**
   * @param targetMatters whether a check looks at {@link #target}
   */
  Observation(ArmDescription arm, ArmDynamics dynamics, boolean targetMatters) {
    this.dynamics = dynamics;
    this.targetMatters = targetMatters;
    actual = new ArmPoints(arm);
    target = new ArmPoints(arm);
    Arrays.fill(lastQ, Double.NaN);
  }

  /** Copies the numbers of a frame. */
  void take(FrameFacts facts) {
    facts.sensors().copyPositionRad(q);
    facts.sensors().copySpeedRadPerS(qd);
    facts.targetPositionRad().copyTo(targetQ);
    facts.targetSpeedRadPerS().copyTo(targetQd);
  }

  /** The first joint with something that is no number, or that there is none. */
  OptionalInt jointWithoutNumber() {
    for (int i = 0; i < Joints.COUNT; i++) {
      if (!Double.isFinite(q[i] + qd[i] + targetQ[i] + targetQd[i])) {
        return OptionalInt.of(i);
      }
    }
    return OptionalInt.empty();
  }

  /** Works out positions, speeds and momentum; of an arm that rests they are those of before. */
  void evaluate(FrameFacts facts) {
    Pose tcpInFlange = facts.tcpInFlange();
    if (!Arrays.equals(q, lastQ) || !Arrays.equals(qd, lastQd) || !tcpInFlange.equals(lastTcp)) {
      JointAngles angles = facts.sensors().angles();
      actual.at(q, angles, qd, tcpInFlange);
      dynamics.linearMomentum(angles, qd, momentum);
      momentumKgMPerS = length(momentum);
      System.arraycopy(q, 0, lastQ, 0, Joints.COUNT);
      System.arraycopy(qd, 0, lastQd, 0, Joints.COUNT);
      lastTcp = tcpInFlange;
    }
    if (targetMatters) {
      target.at(targetQ, targetQd, tcpInFlange);
    }
  }

  /** Momentum of arm and declared payload, kg m/s. */
  double momentumKgMPerS() {
    return momentumKgMPerS;
  }

  static double length(double[] v) {
    return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }
}
