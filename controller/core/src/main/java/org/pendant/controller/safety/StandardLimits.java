package org.pendant.controller.safety;

import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;
import org.pendant.models.arm.Series;

/**
 * Standard limits: those of an arm that has not been configured. None of these numbers is
 * published: those of a UR5e are what users report, those of other arms are derived from them so
 * that every arm can do what its data sheet says.
 */
final class StandardLimits {
  /** Safe joint speed over the published one: room for what the servos overshoot. */
  private static final double JOINT_SPEED_MARGIN = 1.06;

  /**
   * What the safe joint speeds of robots are above the published ones, rad/s, as 95 public
   * installations have them.
   */
  private static final double ROBOT_JOINT_SPEED_MARGIN_RAD_PER_S = 0.2;

  private static final double TOOL_SPEED_M_PER_S = 1.5;

  /** Tool speed of the fast arms over reach times base speed: the elbow adds to it. */
  private static final double FAST_TOOL = 1.3;

  private static final double TOOL_FORCE_N = 150;

  /** Payload from which on the force grows, kg: an undeclared one must not look like a press. */
  private static final double FORCE_PAYLOAD_KG = 12.5;

  private static final double POWER_W = 300;
  private static final double MOMENTUM_KG_M_PER_S = 25;

  /** Mass of a UR5e with its payload, to which its momentum belongs, kg. */
  private static final double MOMENTUM_MASS_KG = 22.7;

  private static final double STOPPING_TIME_S = 0.4;
  private static final double STOPPING_DISTANCE_M = 0.5;

  private StandardLimits() {}

  static SafetyLimits normal(ArmDescription arm) {
    double toolSpeed = toolSpeedMPerS(arm);
    double force = TOOL_FORCE_N * Math.max(1, arm.payloadKg() / FORCE_PAYLOAD_KG);
    double faster = toolSpeed / TOOL_SPEED_M_PER_S;
    double heavier = Math.max(1, massKg(arm) / MOMENTUM_MASS_KG);
    double[] speed = new double[Joints.COUNT];
    double[] min = new double[Joints.COUNT];
    double[] max = new double[Joints.COUNT];
    double fastest = 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      JointLimits joint = arm.joints().get(i);
      speed[i] = JOINT_SPEED_MARGIN * joint.maxSpeedRadPerS();
      min[i] = joint.lowestRad();
      max[i] = joint.highestRad();
      fastest = Math.max(fastest, speed[i]);
    }
    return new SafetyLimits(
        POWER_W * faster,
        MOMENTUM_KG_M_PER_S * heavier * faster,
        Math.max(STOPPING_TIME_S, fastest / Stopping.HARD_RAD_PER_S2),
        STOPPING_DISTANCE_M * Math.max(1, faster),
        toolSpeed,
        force,
        toolSpeed,
        force,
        Joints.of(speed),
        Joints.of(min),
        Joints.of(max));
  }

  /** The largest speed limit that a joint can have, rad/s: that of the robot or ours. */
  static double mostJointSpeedRadPerS(ArmDescription arm, int joint) {
    double published = arm.joints().get(joint).maxSpeedRadPerS();
    return Math.max(JOINT_SPEED_MARGIN * published, published + ROBOT_JOINT_SPEED_MARGIN_RAD_PER_S);
  }

  static SafetyLimits reduced(SafetyLimits normal) {
    double[] speed = normal.jointSpeedRadPerS().toArray();
    for (int i = 0; i < speed.length; i++) {
      speed[i] *= 0.5;
    }
    return new SafetyLimits(
        normal.powerW() * 2 / 3,
        0.4 * normal.momentumKgMPerS(),
        0.75 * normal.stoppingTimeS(),
        0.6 * normal.stoppingDistanceM(),
        0.5 * normal.toolSpeedMPerS(),
        0.8 * normal.toolForceN(),
        0.5 * normal.elbowSpeedMPerS(),
        0.8 * normal.elbowForceN(),
        Joints.of(speed),
        normal.jointMinRad(),
        normal.jointMaxRad());
  }

  /** Fixed limits while the arm is brought back from beyond its own: positions are free. */
  static SafetyLimits recovery(SafetyLimits normal) {
    double speed = Math.toRadians(30);
    double free = Double.POSITIVE_INFINITY;
    return new SafetyLimits(
        80,
        10,
        normal.stoppingTimeS(),
        normal.stoppingDistanceM(),
        0.25,
        100,
        0.25,
        100,
        new Joints(speed, speed, speed, speed, speed, speed),
        new Joints(-free, -free, -free, -free, -free, -free),
        new Joints(free, free, free, free, free, free));
  }

  private static double toolSpeedMPerS(ArmDescription arm) {
    return arm.series() == Series.UR_SERIES
        ? FAST_TOOL * arm.reachM() * arm.joints().get(0).maxSpeedRadPerS()
        : TOOL_SPEED_M_PER_S;
  }

  private static double massKg(ArmDescription arm) {
    double sum = arm.payloadKg();
    for (var link : arm.links()) {
      sum += link.massKg();
    }
    return sum;
  }
}
