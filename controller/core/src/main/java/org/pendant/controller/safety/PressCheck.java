package org.pendant.controller.safety;

import java.util.Optional;
import org.pendant.models.arm.Joints;
import org.pendant.models.time.FrameTime;

/**
 * Pressing check: whether the arm presses on its surroundings or works on them more than a limit
 * allows, for a while: a short blow is left to the collision check, which stops the arm gently.
 */
final class PressCheck {
  static final double FORCE_TOLERANCE_N = 25;
  static final double POWER_TOLERANCE_W = 10;

  /** Frames in a row that count: 100 ms. */
  static final int FRAMES = (int) FrameTime.framesFor(0.1);

  /** Below this lever the base joint cannot feel the elbow, as a share of the upper arm. */
  private static final double MIN_LEVER = 0.2;

  private int power;
  private int tool;
  private int elbow;

  /** Forgets what was felt before. */
  void reset() {
    power = 0;
    tool = 0;
    elbow = 0;
  }

  Optional<SafetyStop> check(FrameFacts facts, Observation seen, SafetyLimits limits) {
    double powerW = powerW(facts, seen);
    double toolN = toolForceN(facts);
    double elbowN = elbowForceN(facts, seen);
    power = powerW > limits.powerW() + POWER_TOLERANCE_W ? power + 1 : 0;
    tool = toolN > limits.toolForceN() + FORCE_TOLERANCE_N ? tool + 1 : 0;
    elbow = elbowN > limits.elbowForceN() + FORCE_TOLERANCE_N ? elbow + 1 : 0;
    double timeS = facts.timeS();
    if (power >= FRAMES) {
      return Optional.of(StopReason.POWER.of(timeS, powerW, limits.powerW()));
    }
    if (tool >= FRAMES) {
      return Optional.of(StopReason.TOOL_FORCE.of(timeS, toolN, limits.toolForceN()));
    }
    if (elbow >= FRAMES) {
      return Optional.of(StopReason.ELBOW_FORCE.of(timeS, elbowN, limits.elbowForceN()));
    }
    return Optional.empty();
  }

  /** Work per time of the torques that arm and payload do not need themselves, W. */
  static double powerW(FrameFacts facts, Observation seen) {
    double sum = 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      sum += facts.sensors().externalTorqueNm(i) * seen.qd[i];
    }
    return Math.abs(sum);
  }

  private static double toolForceN(FrameFacts facts) {
    double fx = facts.externalWrenchAtFlangeInBase().get(0);
    double fy = facts.externalWrenchAtFlangeInBase().get(1);
    double fz = facts.externalWrenchAtFlangeInBase().get(2);
    return Math.sqrt(fx * fx + fy * fy + fz * fz);
  }

  /**
   * The force at the elbow that explains what base and shoulder feel beyond the load on the tool,
   * N. A force along the upper arm cannot be felt.
   */
  static double elbowForceN(FrameFacts facts, Observation seen) {
    ArmPoints points = seen.actual;
    double base = restNm(facts, points, 0, 0, 0, 1, 0, 0, 0);
    double shoulder =
        restNm(
            facts,
            points,
            1,
            points.shoulderAxis(0),
            points.shoulderAxis(1),
            points.shoulderAxis(2),
            points.shoulder(0),
            points.shoulder(1),
            points.shoulder(2));
    double dx = points.elbow(0) - points.shoulder(0);
    double dy = points.elbow(1) - points.shoulder(1);
    double dz = points.elbow(2) - points.shoulder(2);
    double acrossM2 = dx * dx + dy * dy;
    double upperArmM = Math.sqrt(acrossM2 + dz * dz);
    double leverM = Math.max(Math.sqrt(acrossM2), MIN_LEVER * upperArmM);
    double alongN = shoulder / upperArmM;
    double aroundN = base / leverM;
    return Math.sqrt(aroundN * aroundN + alongN * alongN);
  }

  /**
   * The external torque of a joint with axis z through p that the load on the tool does not
   * explain, Nm. The motor's surplus balances the load, hence the sum.
   */
  private static double restNm(
      FrameFacts facts,
      ArmPoints points,
      int joint,
      double zx,
      double zy,
      double zz,
      double px,
      double py,
      double pz) {
    var load = facts.externalWrenchAtFlangeInBase();
    double rx = points.flange(0) - px;
    double ry = points.flange(1) - py;
    double rz = points.flange(2) - pz;
    double mx = load.get(3) + ry * load.get(2) - rz * load.get(1);
    double my = load.get(4) + rz * load.get(0) - rx * load.get(2);
    double mz = load.get(5) + rx * load.get(1) - ry * load.get(0);
    return facts.sensors().externalTorqueNm(joint) + zx * mx + zy * my + zz * mz;
  }
}
