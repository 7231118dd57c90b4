package org.pendant.controller.safety;

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
    requireAboveZero("stopping time", stoppingTimeS, "s");
    requireAboveZero("stopping distance", stoppingDistanceM, "m");
    requireAboveZero("tool speed", toolSpeedMPerS, "m/s");
    requireAboveZero("tool force", toolForceN, "N");
    requireAboveZero("elbow speed", elbowSpeedMPerS, "m/s");
    requireAboveZero("elbow force", elbowForceN, "N");
    for (int i = 0; i < Joints.COUNT; i++) {
      requireAboveZero("speed of joint " + i, jointSpeedRadPerS.get(i), "rad/s");
      if (!(jointMinRad.get(i) < jointMaxRad.get(i))) {
        throw new IllegalArgumentException(
            "safety limits: joint "
                + i
                + " may be at "
                + jointMinRad.get(i)
                + " to "
                + jointMaxRad.get(i)
                + " rad, the first must be below the second");
      }
    }
  }

  private static void requireAboveZero(String name, double value, String unit) {
    if (!(value > 0)) {
      throw new IllegalArgumentException(
          "safety limits: " + name + " is " + value + " " + unit + ", must be above 0");
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
    requireAtMost("stopping time", stoppingTimeS, wider.stoppingTimeS, "s");
    requireAtMost("stopping distance", stoppingDistanceM, wider.stoppingDistanceM, "m");
    requireAtMost("tool speed", toolSpeedMPerS, wider.toolSpeedMPerS, "m/s");
    requireAtMost("tool force", toolForceN, wider.toolForceN, "N");
    requireAtMost("elbow speed", elbowSpeedMPerS, wider.elbowSpeedMPerS, "m/s");
    requireAtMost("elbow force", elbowForceN, wider.elbowForceN, "N");
    for (int i = 0; i < Joints.COUNT; i++) {
      requireAtMost(
          "speed of joint " + i, jointSpeedRadPerS.get(i), wider.jointSpeedRadPerS.get(i), "rad/s");
      if (!(jointMinRad.get(i) >= wider.jointMinRad.get(i)
          && jointMaxRad.get(i) <= wider.jointMaxRad.get(i))) {
        throw new IllegalArgumentException(
            "reduced limits: joint "
                + i
                + " may be at "
                + jointMinRad.get(i)
                + " to "
                + jointMaxRad.get(i)
                + " rad, must be within the normal range "
                + wider.jointMinRad.get(i)
                + " to "
                + wider.jointMaxRad.get(i)
                + " rad");
      }
    }
  }

  private static void requireAtMost(String name, double value, double most, String unit) {
    if (!(value <= most)) {
      throw new IllegalArgumentException(
          "reduced limits: "
              + name
              + " is "
              + value
              + " "
              + unit
              + ", must be at most the normal "
              + most
              + " "
              + unit);
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
