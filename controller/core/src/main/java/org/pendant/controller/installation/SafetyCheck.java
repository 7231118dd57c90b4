package org.pendant.controller.installation;

import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyLimits;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;

/** Whether safety limits are such as an arm can have. */
final class SafetyCheck {
  /** What rounding to degrees may do, rad and rad/s. */
  private static final double ROUNDING = 1e-6;

  private final ProblemList problems;
  private final ArmDescription arm;

  SafetyCheck(ProblemList problems, ArmDescription arm) {
    this.problems = problems;
    this.arm = arm;
  }

  void check(SafetyConfiguration safety) {
    // what is reduced is within what is normal, or there were no such configuration
    check("safety.normal.", safety.normal());
  }

  private void check(String field, SafetyLimits limits) {
    SafetyLimits most = SafetyConfiguration.standard(arm).normal();
    finite(field + "powerW", limits.powerW());
    finite(field + "momentumKgMPerS", limits.momentumKgMPerS());
    finite(field + "stoppingTimeS", limits.stoppingTimeS());
    finite(field + "stoppingDistanceM", limits.stoppingDistanceM());
    finite(field + "toolSpeedMPerS", limits.toolSpeedMPerS());
    finite(field + "toolForceN", limits.toolForceN());
    finite(field + "elbowSpeedMPerS", limits.elbowSpeedMPerS());
    finite(field + "elbowForceN", limits.elbowForceN());
    for (int i = 0; i < Joints.COUNT; i++) {
      int joint = i;
      double speed = limits.jointSpeedRadPerS().get(i);
      double mostSpeed = most.jointSpeedRadPerS().get(i);
      problems.require(
          speed <= mostSpeed + ROUNDING,
          field + "jointSpeedRadPerS",
          () ->
              "joint "
                  + joint
                  + " may turn at "
                  + speed
                  + " rad/s, must be at most "
                  + mostSpeed
                  + " on "
                  + arm.id());
      double min = limits.jointMinRad().get(i);
      double max = limits.jointMaxRad().get(i);
      problems.require(
          range(min, max, most.jointMinRad().get(i), most.jointMaxRad().get(i)),
          field + "jointMinRad",
          () ->
              "joint "
                  + joint
                  + " may be at "
                  + min
                  + " to "
                  + max
                  + " rad, must be within "
                  + most.jointMinRad().get(joint)
                  + " to "
                  + most.jointMaxRad().get(joint)
                  + " on "
                  + arm.id());
    }
  }

  /** No limit at all stands for that of the arm. */
  private static boolean range(double min, double max, double least, double most) {
    return (min >= least - ROUNDING || Double.isInfinite(min))
        && (max <= most + ROUNDING || Double.isInfinite(max));
  }

  private void finite(String field, double value) {
    problems.require(
        Double.isFinite(value), field, () -> "it is " + value + ", must be a finite number");
  }
}
