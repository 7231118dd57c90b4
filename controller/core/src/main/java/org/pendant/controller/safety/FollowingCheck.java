package org.pendant.controller.safety;

import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.time.FrameTime;

/**
 * Following check: whether the arm stays with its target (C153) and nothing pushes it (C157). The
 * thresholds are not published; these are our choice.
 */
final class FollowingCheck {
  /** How far base, shoulder and elbow may be from their targets while the target moves, rad. */
  static final double ARM_DEVIATION_RAD = 0.05;

  /** As {@link #ARM_DEVIATION_RAD}, for the wrists. */
  static final double WRIST_DEVIATION_RAD = 0.1;

  /** How far a joint may be from its target while the arm holds its place, rad. */
  static final double HOLDING_DEVIATION_RAD = 0.2;

  /** Frames in a row that count: 20 ms. */
  static final int DEVIATING_FRAMES = (int) FrameTime.framesFor(0.02);

  /** Torque from outside, as a share of what the joint can do, that is a collision. */
  static final double COLLISION_SHARE = 0.35;

  /** As {@link #COLLISION_SHARE}, while the arm holds its place. */
  static final double HOLDING_COLLISION_SHARE = 0.7;

  /** Frames in a row, pushed the same way, that count: 10 ms. */
  static final int PUSHED_FRAMES = (int) FrameTime.framesFor(0.01);

  private static final int FIRST_WRIST = 3;

  private final double[] maxTorqueNm = new double[Joints.COUNT];
  private final int[] deviating = new int[Joints.COUNT];

  /** Frames in a row that each joint was pushed, negative for the negative direction. */
  private final int[] pushed = new int[Joints.COUNT];

  private double deviationRatio;
  private double collisionRatio;

  FollowingCheck(ArmDescription arm) {
    for (int i = 0; i < Joints.COUNT; i++) {
      maxTorqueNm[i] = arm.joints().get(i).maxTorqueNm();
    }
  }

  /** Forgets what was seen before. */
  void reset() {
    deviationRatio = 0;
    collisionRatio = 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      deviating[i] = 0;
      pushed[i] = 0;
    }
  }

  /**
   * How far a joint may be from its target, rad.
   *
   * @param holding whether the arm holds its place with all its might
   */
  static double allowedDeviationRad(int joint, boolean holding) {
    if (holding) {
      return HOLDING_DEVIATION_RAD;
    }
    return joint < FIRST_WRIST ? ARM_DEVIATION_RAD : WRIST_DEVIATION_RAD;
  }

  /** How much torque from outside a joint may feel, Nm. */
  double allowedTorqueNm(int joint, boolean holding) {
    return maxTorqueNm[joint] * (holding ? HOLDING_COLLISION_SHARE : COLLISION_SHARE);
  }

  /** The largest share of the allowed deviation that a joint has in this frame, 0 to 1. */
  double deviationRatio() {
    return deviationRatio;
  }

  /** The largest share of the allowed torque from outside that a joint has, 0 to 1. */
  double collisionRatio() {
    return collisionRatio;
  }

  Optional<SafetyStop> check(FrameFacts facts, Observation seen, boolean holding) {
    double timeS = facts.timeS();
    Optional<SafetyStop> stop = Optional.empty();
    double largestDeviation = 0;
    double largestPush = 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      double torque = facts.pressing() ? 0 : facts.sensors().externalTorqueNm(i);
      double allowedTorque = allowedTorqueNm(i, holding);
      pushed[i] = pushedFrames(pushed[i], torque, allowedTorque);
      double deviation = Math.abs(seen.targetQ[i] - seen.q[i]);
      double allowedDeviation = allowedDeviationRad(i, holding);
      largestDeviation = Math.max(largestDeviation, deviation / allowedDeviation);
      largestPush = Math.max(largestPush, Math.abs(torque) / allowedTorque);
      deviating[i] = deviation > allowedDeviation ? deviating[i] + 1 : 0;
      if (stop.isEmpty() && Math.abs(pushed[i]) >= PUSHED_FRAMES) {
        stop = Optional.of(StopReason.COLLISION.ofJoint(i, timeS, Math.abs(torque), allowedTorque));
      } else if (stop.isEmpty() && deviating[i] >= DEVIATING_FRAMES) {
        stop =
            Optional.of(
                StopReason.POSITION_DEVIATION.ofJoint(i, timeS, deviation, allowedDeviation));
      }
    }
    deviationRatio = Math.min(largestDeviation, 1);
    collisionRatio = Math.min(largestPush, 1);
    return stop;
  }

  private static int pushedFrames(int before, double torque, double allowed) {
    if (torque > allowed) {
      return Math.max(before, 0) + 1;
    }
    return torque < -allowed ? Math.min(before, 0) - 1 : 0;
  }
}
