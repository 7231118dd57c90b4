package org.pendant.controller.motion;

import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * A straight line in joint space: all joints start and stop together, in proportion (manual 15.29).
 *
 * <p>Speed and acceleration are those of the leading axis, the joint that turns farthest. A speed
 * that would drive any joint beyond its limit is lowered beforehand, as in motion version 2 (manual
 * 14); a duration that would is stretched.
 */
public final class MoveJ implements Motion {
  private final Joints from;
  private final Joints goal;
  private final Pose waypoint;
  private final TrapezoidProfile profile;
  private final double durationAskedS;
  private final double[] perDistance = new double[Joints.COUNT];

  /**
   * Plans a move.
   *
   * @param from joint positions at its begin, rad
   * @param goal joint positions at its end, rad, within the ranges of the arm
   * @param waypoint pose of the TCP at its end, in the base frame
   * @param limits in rad
   */
  public MoveJ(ArmDescription arm, Joints from, Joints goal, Pose waypoint, MoveLimits limits) {
    this.from = from;
    this.goal = goal;
    this.waypoint = waypoint;
    this.durationAskedS = limits.durationS();
    double distance = goal.maxAbsDifference(from);
    double fastest = Double.POSITIVE_INFINITY;
    for (int i = 0; i < Joints.COUNT; i++) {
      double part = distance == 0 ? 0 : (goal.get(i) - from.get(i)) / distance;
      perDistance[i] = part;
      fastest = Math.min(fastest, arm.joints().get(i).maxSpeedRadPerS() / Math.abs(part));
    }
    TrapezoidProfile wanted = limits.over(distance);
    profile =
        wanted.cruiseSpeed() > fastest
            ? TrapezoidProfile.of(distance, fastest, wanted.acceleration())
            : wanted;
  }

  /** Whether the move takes longer than was asked, because a joint cannot turn that fast. */
  public boolean stretched() {
    return durationAskedS > 0 && profile.durationS() > durationAskedS;
  }

  @Override
  public double durationS() {
    return profile.durationS();
  }

  @Override
  public Optional<MotionFailure> sample(double timeS, MotionSample sample) {
    if (timeS >= profile.durationS()) {
      goal.copyTo(sample.position);
      sample.rest();
      return Optional.empty();
    }
    double position = profile.position(timeS);
    double speed = profile.speed(timeS);
    double acceleration = profile.acceleration(timeS);
    for (int i = 0; i < Joints.COUNT; i++) {
      sample.position[i] = from.get(i) + perDistance[i] * position;
      sample.speed[i] = perDistance[i] * speed;
      sample.acceleration[i] = perDistance[i] * acceleration;
    }
    return Optional.empty();
  }

  @Override
  public Optional<Pose> waypoint() {
    return Optional.of(waypoint);
  }
}
