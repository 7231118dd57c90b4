package org.pendant.controller.safety;

import java.util.List;
import java.util.Optional;
import org.pendant.models.arm.Joints;
import org.pendant.models.time.FrameTime;

/**
 * Travel check: whether the target could still stop before position limits, planes and the largest
 * tilt (C150 to C152). Only what moves towards a limit counts: an arm at its border may move away.
 */
final class TravelCheck {
  /** What rounding may do to a path that ends exactly at a limit, rad and m. */
  private static final double ROUNDING = 1e-6;

  private final List<SafetyPlane> planes;
  private final Optional<ToolDirection> direction;

  /** How fast the joints were in the frame before, rad/s. */
  private final double[] lastQd = new double[Joints.COUNT];

  /** How fast they are in the next one if they continue speeding up as they do, rad/s. */
  private final double[] nextQd = new double[Joints.COUNT];

  TravelCheck(SafetyConfiguration configuration) {
    planes = configuration.planes();
    direction = configuration.toolDirection();
  }

  /** The stop that is needed now, if one is. */
  Optional<SafetyStop> check(double timeS, Observation seen, SafetyLimits limits, boolean reduced) {
    double stopS = Stopping.timeS(seen.targetQd);
    if (stopS == 0) {
      return Optional.empty();
    }
    // speeds fall evenly to zero, so half of the time counts
    double travelS = stopS / 2;
    Optional<SafetyStop> stop = joints(timeS, seen, limits, travelS);
    for (int i = 0; i < planes.size() && stop.isEmpty(); i++) {
      if (planes.get(i).applies().restricts(reduced)) {
        stop = plane(i, timeS, seen.target, travelS);
      }
    }
    if (stop.isEmpty() && direction.isPresent()) {
      stop = tilt(direction.get(), timeS, seen.target, reduced, travelS);
    }
    return stop;
  }

  /** Takes the speeds of a frame, with which the next one's are compared. */
  void remember(Observation seen) {
    System.arraycopy(seen.targetQd, 0, lastQd, 0, Joints.COUNT);
  }

  /**
   * The stop that is needed now because the next frame is too late: of a target that no check has
   * planned, torques may have changed the speed a lot by then.
   */
  Optional<SafetyStop> joints(double timeS, Observation seen, SafetyLimits limits) {
    for (int i = 0; i < Joints.COUNT; i++) {
      double gained = seen.targetQd[i] - lastQd[i];
      nextQd[i] = seen.targetQd[i] + (gained * seen.targetQd[i] > 0 ? gained : 0);
    }
    double travelS = Stopping.timeS(nextQd) / 2;
    for (int i = 0; i < Joints.COUNT; i++) {
      double speed = nextQd[i];
      double nextQ = seen.targetQ[i] + (seen.targetQd[i] + speed) / 2 * FrameTime.FRAME_S;
      double end = nextQ + speed * travelS;
      double limit = speed > 0 ? limits.jointMaxRad().get(i) : limits.jointMinRad().get(i);
      if (speed * (end - limit) > 0 && Math.abs(end - limit) > ROUNDING) {
        return Optional.of(StopReason.JOINT_LIMIT_NEAR.ofJoint(i, timeS, end, limit));
      }
    }
    return Optional.empty();
  }

  private static Optional<SafetyStop> joints(
      double timeS, Observation seen, SafetyLimits limits, double travelS) {
    for (int i = 0; i < Joints.COUNT; i++) {
      double speed = seen.targetQd[i];
      double end = seen.targetQ[i] + speed * travelS;
      double max = limits.jointMaxRad().get(i);
      double min = limits.jointMinRad().get(i);
      if (speed > 0 && end > max + ROUNDING) {
        return Optional.of(StopReason.JOINT_LIMIT_NEAR.ofJoint(i, timeS, end, max));
      }
      if (speed < 0 && end < min - ROUNDING) {
        return Optional.of(StopReason.JOINT_LIMIT_NEAR.ofJoint(i, timeS, end, min));
      }
    }
    return Optional.empty();
  }

  private Optional<SafetyStop> plane(int number, double timeS, ArmPoints target, double travelS) {
    SafetyPlane plane = planes.get(number);
    Axis side = plane.allowedSide();
    double toolSpeed =
        side.dot(target.toolVelocity(0), target.toolVelocity(1), target.toolVelocity(2));
    double toolEnd =
        plane.insideM(target.tool(0), target.tool(1), target.tool(2)) + toolSpeed * travelS;
    if (toolSpeed < 0 && toolEnd < -ROUNDING) {
      return Optional.of(StopReason.PLANE_NEAR.ofPlane("tool", plane, number, timeS, toolEnd, 0));
    }
    if (plane.elbow()) {
      double elbowSpeed =
          side.dot(target.elbowVelocity(0), target.elbowVelocity(1), target.elbowVelocity(2));
      double elbowEnd =
          plane.insideM(target.elbow(0), target.elbow(1), target.elbow(2)) + elbowSpeed * travelS;
      if (elbowSpeed < 0 && elbowEnd < -ROUNDING) {
        return Optional.of(
            StopReason.PLANE_NEAR.ofPlane("elbow", plane, number, timeS, elbowEnd, 0));
      }
    }
    return Optional.empty();
  }

  private static Optional<SafetyStop> tilt(
      ToolDirection direction, double timeS, ArmPoints target, boolean reduced, double travelS) {
    if (!direction.applies().restricts(reduced)) {
      return Optional.empty();
    }
    target.point(direction.toolInFlange());
    double speed = direction.angleSpeedRadPerS(target);
    double end = direction.angleRad(target) + speed * travelS;
    double largest = direction.largestAngleRad();
    return speed > 0 && end > largest + ROUNDING
        ? Optional.of(StopReason.TOOL_DIRECTION_NEAR.of(timeS, end, largest))
        : Optional.empty();
  }
}
