package org.pendant.controller.freedrive;

import org.pendant.controller.safety.SafetyLimits;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.time.FrameTime;
import org.pendant.motion.PathLimiter;

/**
 * Resistance of a guided arm to the hand: a little always, much when it gets too fast, and without
 * end at the ends of the joints' ranges.
 */
final class Resistance {
  /** Torque at 1 rad/s, as a share of the largest torque of the joint; our choice. */
  private static final double SHARE_S_PER_RAD = 0.12;

  /** From this share of a speed limit on it gets harder to push. */
  private static final double SLOWING_FROM = 0.7;

  /** How many times as hard it is at the limit. */
  private static final double AT_LIMIT = 30;

  /** How many times as hard it is in a singularity while axes are locked. */
  private static final double IN_SINGULARITY = 20;

  /** How many times as hard a wall resists a joint that is faster than it allows. */
  private static final double AT_WALL = 100;

  private static final int N = Joints.COUNT;

  private final double[] usual = new double[N];
  private final JointLimitSprings walls;
  private final PathLimiter speeds;

  /**
   * @param speeds knows how fast the arm may go
   */
  Resistance(ArmDescription arm, PathLimiter speeds) {
    this.speeds = speeds;
    walls = new JointLimitSprings(arm);
    for (int i = 0; i < N; i++) {
      usual[i] = SHARE_S_PER_RAD * arm.joints().get(i).maxTorqueNm();
    }
  }

  /** Freedrive begins at joint positions, rad. */
  void begin(double[] q) {
    walls.begin(q);
  }

  /**
   * Adds torques, and writes the damping of each joint.
   *
   * @param limits that hold now
   * @param singularity measure of the nearest singularity if it makes the arm harder to move, 1 if
   *     not
   */
  void add(
      SafetyLimits limits,
      double singularity,
      double[] q,
      double[] qd,
      double[] torqueNm,
      double[] dampingNmSPerRad) {
    walls.update(limits, q);
    double factor = 1 + tooFast(q, qd) + tooClose(singularity);
    for (int i = 0; i < N; i++) {
      dampingNmSPerRad[i] = factor * usual[i];
      double most = walls.mostRadPerS(i, q[i] + FrameTime.FRAME_S * qd[i]);
      double least = walls.leastRadPerS(i, q[i] + FrameTime.FRAME_S * qd[i]);
      double allowed = Math.max(least, Math.min(most, qd[i]));
      if (allowed != qd[i]) {
        double wall = AT_WALL * usual[i];
        dampingNmSPerRad[i] += wall;
        torqueNm[i] += wall * allowed;
      }
    }
  }

  private double tooFast(double[] q, double[] qd) {
    double share = 1 / speeds.largestScaling(q, qd);
    double beyond = Math.max(0, share - SLOWING_FROM) / (1 - SLOWING_FROM);
    return AT_LIMIT * beyond * beyond;
  }

  private static double tooClose(double measure) {
    double into = Math.max(0, 1 - measure / SingularityDistance.NEAR_MEASURE);
    return IN_SINGULARITY * into * into;
  }
}
