package org.pendant.controller.safety;

import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.pose.Pose;
import org.pendant.motion.PathLimiter;

/**
 * Speed caps: slow paths down so that the arm stays clear of its limits on speeds, momentum,
 * stopping time and stopping distance, and no joint has to turn faster than it can. Power is left
 * to the check of violations: the limit is on work done on the surroundings, which is unknown
 * before something is touched.
 */
public final class SpeedCaps implements PathLimiter {
  /** Share of each limit that is used: the rest is for servos that overshoot. */
  static final double SHARE = 0.97;

  private final ActiveLimits limits;
  private final ArmDynamics dynamics;
  private final ArmPoints points;
  private final double[] maxSpeedRadPerS = new double[Joints.COUNT];
  private final double[] momentum = new double[3];
  private Pose tcpInFlange = Pose.ZERO;
  private double reducedShare;

  /**
   * Caps for the limits that hold in a safety system.
   *
   * @param dynamics masses of arm and declared payload, kept up to date by the caller
   */
  public SpeedCaps(ArmDescription arm, ArmDynamics dynamics, SafetySystem safety) {
    limits = safety.activeLimits();
    this.dynamics = dynamics;
    points = new ArmPoints(arm);
    for (int i = 0; i < Joints.COUNT; i++) {
      maxSpeedRadPerS[i] = arm.joints().get(i).maxSpeedRadPerS();
    }
  }

  /** The tool centre point whose speed counts from now on. */
  public void setTool(Pose tcpInFlange) {
    this.tcpInFlange = tcpInFlange;
  }

  @Override
  public double largestScaling(double[] q, double[] qd) {
    // the drives compute what this target needs next, by the same masses
    dynamics.angles().at(q);
    points.at(q, dynamics.angles(), qd, tcpInFlange);
    return largestScaling(qd);
  }

  @Override
  public double largestScaling(double[] q, double[] qd, double[][] frames) {
    points.at(frames, qd, tcpInFlange);
    return largestScaling(qd);
  }

  private double largestScaling(double[] qd) {
    reducedShare = limits.reducedShare(points);
    SafetyLimits from = limits.unreduced();
    SafetyLimits to = limits.reducedSet();
    double toolSpeed = points.toolSpeedMPerS();
    dynamics.linearMomentum(points.frames(), qd, momentum);
    double scaling = joints(from.jointSpeedRadPerS(), to.jointSpeedRadPerS(), qd);
    scaling = Math.min(scaling, cap(from.toolSpeedMPerS(), to.toolSpeedMPerS()) / toolSpeed);
    scaling =
        Math.min(
            scaling, cap(from.elbowSpeedMPerS(), to.elbowSpeedMPerS()) / points.elbowSpeedMPerS());
    scaling =
        Math.min(
            scaling,
            cap(from.momentumKgMPerS(), to.momentumKgMPerS()) / Observation.length(momentum));
    double stopS = Stopping.timeS(qd);
    scaling = Math.min(scaling, cap(from.stoppingTimeS(), to.stoppingTimeS()) / stopS);
    // both the speed and the time to stop shrink with the scaling
    double travelM = toolSpeed * stopS / 2;
    double farthestM = cap(from.stoppingDistanceM(), to.stoppingDistanceM());
    return Math.min(scaling, Math.sqrt(farthestM / travelM));
  }

  private double joints(Joints from, Joints to, double[] qd) {
    double scaling = joint(0, from.q0(), to.q0(), qd);
    scaling = Math.min(scaling, joint(1, from.q1(), to.q1(), qd));
    scaling = Math.min(scaling, joint(2, from.q2(), to.q2(), qd));
    scaling = Math.min(scaling, joint(3, from.q3(), to.q3(), qd));
    scaling = Math.min(scaling, joint(4, from.q4(), to.q4(), qd));
    return Math.min(scaling, joint(5, from.q5(), to.q5(), qd));
  }

  private double joint(int i, double normal, double reduced, double[] qd) {
    return Math.min(cap(normal, reduced), maxSpeedRadPerS[i]) / Math.abs(qd[i]);
  }

  /** The largest value to aim at, between the normal and the reduced limit. */
  private double cap(double normal, double reduced) {
    return SHARE * (normal + reducedShare * (reduced - normal));
  }
}
