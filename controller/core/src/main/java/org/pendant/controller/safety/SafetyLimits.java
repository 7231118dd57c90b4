package org.pendant.controller.safety;

import static org.pendant.controller.safety.SafetyTexts.text;

import org.pendant.models.arm.Joints;
import org.pendant.motion.force.JointPositionLimits;

/**
 * Safety limits: one set of them.
 *
 * @param powerW work per time that the arm may do on its surroundings, W
 * @param momentumKgMPerS momentum of arm and payload, kg m/s
 * @param stoppingTimeS longest time that a stop may take, s
 * @param stoppingDistanceM longest way of the tool during a stop, m
 * @param toolSpeedMPerS speed of the tool centre point, m/s
 * @param toolForceN force between tool and surroundings, N
 * @param elbowSpeedMPerS speed of the elbow, m/s
 * @param elbowForceN force between elbow and surroundings, N
 * @param jointSpeedRadPerS speed of each joint either way, rad/s
 * @param jointMinRad smallest position of each joint, rad; minus infinity for none
 * @param jointMaxRad largest position of each joint, rad; infinity for none
 */
public record SafetyLimits(
    double powerW,
    double momentumKgMPerS,
    double stoppingTimeS,
    double stoppingDistanceM,
    double toolSpeedMPerS,
    double toolForceN,
    double elbowSpeedMPerS,
    double elbowForceN,
    Joints jointSpeedRadPerS,
    Joints jointMinRad,
    Joints jointMaxRad)
    implements JointPositionLimits {
  /**
   * Checks the limits.
   *
   * @throws IllegalArgumentException if a range is empty, or another number is not above 0
   */
  public SafetyLimits {
    requireAboveZero("power", powerW, "W");
    requireAboveZero("momentum", momentumKgMPerS, "kg m/s");
    requireAboveZero("stoppingTime", stoppingTimeS, "s");
    requireAboveZero("stoppingDistance", stoppingDistanceM, "m");
    requireAboveZero("toolSpeed", toolSpeedMPerS, "m/s");
    requireAboveZero("toolForce", toolForceN, "N");
    requireAboveZero("elbowSpeed", elbowSpeedMPerS, "m/s");
    requireAboveZero("elbowForce", elbowForceN, "N");
    for (int i = 0; i < Joints.COUNT; i++) {
      requireAboveZero("speedOfJoint", jointSpeedRadPerS.get(i), "rad/s", i);
      if (!(jointMinRad.get(i) < jointMaxRad.get(i))) {
        throw new IllegalArgumentException(
            text("jointRangeEmpty", i, jointMinRad.get(i), jointMaxRad.get(i)));
      }
    }
  }

  /**
   * Reads texts only where something is wrong.
   *
   * @param joint number of the joint, if it is the limit of one
   */
  private static void requireAboveZero(String nameKey, double value, String unit, Object... joint) {
    if (!(value > 0)) {
      throw new IllegalArgumentException(text("limitAboveZero", text(nameKey, joint), value, unit));
    }
  }

  /**
   * Checks that this set allows nothing that {@code wider} forbids.
   *
   * @throws IllegalArgumentException if it does; the message names the first such limit
   */
  void requireWithin(SafetyLimits wider) {
    requireAtMost("power", powerW, wider.powerW, "W");
    requireAtMost("momentum", momentumKgMPerS, wider.momentumKgMPerS, "kg m/s");
    requireAtMost("stoppingTime", stoppingTimeS, wider.stoppingTimeS, "s");
    requireAtMost("stoppingDistance", stoppingDistanceM, wider.stoppingDistanceM, "m");
    requireAtMost("toolSpeed", toolSpeedMPerS, wider.toolSpeedMPerS, "m/s");
    requireAtMost("toolForce", toolForceN, wider.toolForceN, "N");
    requireAtMost("elbowSpeed", elbowSpeedMPerS, wider.elbowSpeedMPerS, "m/s");
    requireAtMost("elbowForce", elbowForceN, wider.elbowForceN, "N");
    for (int i = 0; i < Joints.COUNT; i++) {
      requireAtMost(
          "speedOfJoint", jointSpeedRadPerS.get(i), wider.jointSpeedRadPerS.get(i), "rad/s", i);
      if (!(jointMinRad.get(i) >= wider.jointMinRad.get(i)
          && jointMaxRad.get(i) <= wider.jointMaxRad.get(i))) {
        throw new IllegalArgumentException(
            text(
                "reducedJointRange",
                i,
                jointMinRad.get(i),
                jointMaxRad.get(i),
                wider.jointMinRad.get(i),
                wider.jointMaxRad.get(i)));
      }
    }
  }

  private static void requireAtMost(
      String nameKey, double value, double most, String unit, Object... joint) {
    if (!(value <= most)) {
      throw new IllegalArgumentException(
          text("limitAtMostNormal", text(nameKey, joint), value, unit, most));
    }
  }

  /** For each limit the tighter of this set and {@code other}. */
  SafetyLimits tighterOf(SafetyLimits other) {
    double[] speed = new double[Joints.COUNT];
    double[] min = new double[Joints.COUNT];
    double[] max = new double[Joints.COUNT];
    for (int i = 0; i < Joints.COUNT; i++) {
      speed[i] = Math.min(jointSpeedRadPerS.get(i), other.jointSpeedRadPerS.get(i));
      min[i] = Math.max(jointMinRad.get(i), other.jointMinRad.get(i));
      max[i] = Math.min(jointMaxRad.get(i), other.jointMaxRad.get(i));
    }
    return new SafetyLimits(
        Math.min(powerW, other.powerW),
        Math.min(momentumKgMPerS, other.momentumKgMPerS),
        Math.min(stoppingTimeS, other.stoppingTimeS),
        Math.min(stoppingDistanceM, other.stoppingDistanceM),
        Math.min(toolSpeedMPerS, other.toolSpeedMPerS),
        Math.min(toolForceN, other.toolForceN),
        Math.min(elbowSpeedMPerS, other.elbowSpeedMPerS),
        Math.min(elbowForceN, other.elbowForceN),
        Joints.of(speed),
        Joints.of(min),
        Joints.of(max));
  }
}
