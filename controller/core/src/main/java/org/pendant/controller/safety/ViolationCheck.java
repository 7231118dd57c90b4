package org.pendant.controller.safety;

import java.util.List;
import java.util.Optional;
import org.pendant.models.arm.Joints;

/**
 * Violation check: whether the actual arm exceeds a limit by more than the safety functions can
 * measure (C191). The tolerances are those of the user manuals.
 */
final class ViolationCheck {
  static final double JOINT_POSITION_TOLERANCE_RAD = Math.toRadians(5);
  static final double JOINT_SPEED_TOLERANCE_RAD_PER_S = Math.toRadians(1.15);
  static final double SPEED_TOLERANCE_M_PER_S = 0.05;
  static final double MOMENTUM_TOLERANCE_KG_M_PER_S = 3;
  static final double PLANE_TOLERANCE_M = 0.04;
  static final double TILT_TOLERANCE_RAD = Math.toRadians(3);

  private final List<SafetyPlane> planes;
  private final Optional<ToolDirection> direction;

  ViolationCheck(SafetyConfiguration configuration) {
    planes = configuration.planes();
    direction = configuration.toolDirection();
  }

  /**
   * Where the arm is beyond a limit.
   *
   * @param tolerance 1 to forgive what cannot be measured, 0 for the limits as they are
   */
  Optional<SafetyStop> position(
      double timeS,
      double[] q,
      ArmPoints points,
      SafetyLimits limits,
      boolean reduced,
      double tolerance) {
    double jointTolerance = tolerance * JOINT_POSITION_TOLERANCE_RAD;
    for (int i = 0; i < Joints.COUNT; i++) {
      double max = limits.jointMaxRad().get(i);
      double min = limits.jointMinRad().get(i);
      if (q[i] > max + jointTolerance || q[i] < min - jointTolerance) {
        return Optional.of(
            StopReason.JOINT_POSITION.ofJoint(i, timeS, q[i], q[i] > max ? max : min));
      }
    }
    for (int i = 0; i < planes.size(); i++) {
      SafetyPlane plane = planes.get(i);
      if (plane.applies().restricts(reduced)
          && plane.insideM(points) < -tolerance * PLANE_TOLERANCE_M) {
        return Optional.of(beyond(plane, i, timeS, points));
      }
    }
    return tilt(timeS, points, reduced, tolerance * TILT_TOLERANCE_RAD);
  }

  private static SafetyStop beyond(SafetyPlane plane, int number, double timeS, ArmPoints points) {
    double inside = plane.insideM(points);
    boolean tool = plane.insideM(points.tool(0), points.tool(1), points.tool(2)) == inside;
    return StopReason.PLANE.ofPlane(tool ? "tool" : "elbow", plane, number, timeS, inside, 0);
  }

  private Optional<SafetyStop> tilt(
      double timeS, ArmPoints points, boolean reduced, double tolerance) {
    if (direction.isEmpty() || !direction.get().applies().restricts(reduced)) {
      return Optional.empty();
    }
    points.point(direction.get().toolInFlange());
    double angle = direction.get().angleRad(points);
    double largest = direction.get().largestAngleRad();
    return angle > largest + tolerance
        ? Optional.of(StopReason.TOOL_DIRECTION.of(timeS, angle, largest))
        : Optional.empty();
  }

  /** What moves too fast. */
  Optional<SafetyStop> motion(double timeS, Observation seen, SafetyLimits limits) {
    for (int i = 0; i < Joints.COUNT; i++) {
      double limit = limits.jointSpeedRadPerS().get(i);
      if (Math.abs(seen.qd[i]) > limit + JOINT_SPEED_TOLERANCE_RAD_PER_S) {
        return Optional.of(StopReason.JOINT_SPEED.ofJoint(i, timeS, Math.abs(seen.qd[i]), limit));
      }
    }
    double toolSpeed = seen.actual.toolSpeedMPerS();
    if (toolSpeed > limits.toolSpeedMPerS() + SPEED_TOLERANCE_M_PER_S) {
      return Optional.of(StopReason.TOOL_SPEED.of(timeS, toolSpeed, limits.toolSpeedMPerS()));
    }
    double elbowSpeed = seen.actual.elbowSpeedMPerS();
    if (elbowSpeed > limits.elbowSpeedMPerS() + SPEED_TOLERANCE_M_PER_S) {
      return Optional.of(StopReason.ELBOW_SPEED.of(timeS, elbowSpeed, limits.elbowSpeedMPerS()));
    }
    double momentum = seen.momentumKgMPerS();
    if (momentum > limits.momentumKgMPerS() + MOMENTUM_TOLERANCE_KG_M_PER_S) {
      return Optional.of(StopReason.MOMENTUM.of(timeS, momentum, limits.momentumKgMPerS()));
    }
    return Optional.empty();
  }
}
