package org.pendant.controller.motion;

import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/**
 * A straight line in joint space: all joints turn in proportion (manual 15.29). Its unit is rad of
 * the leading axis, the joint that turns farthest.
 */
final class JointLine implements MotionPath {
  /** Steps in which the line is looked at for where it crosses a sphere. */
  private static final int STEPS = 32;

  /** Halvings of one of them. */
  private static final int HALVINGS = 40;

  private final ForwardKinematics forward;
  private final Joints from;
  private final Joints goal;
  private final Pose waypoint;
  private final Pose tcpInFlange;
  private final double length;
  private final double fastest;
  private final double[] perLength = new double[Joints.COUNT];

  /**
   * A line.
   *
   * @param from joint positions at its begin, rad
   * @param goal joint positions at its end, rad, within the ranges of the arm
   * @param waypoint pose of the TCP at its end, in the base frame
   */
  JointLine(ArmDescription arm, Joints from, Joints goal, Pose waypoint, Pose tcpInFlange) {
    forward = new ForwardKinematics(arm.dh());
    this.from = from;
    this.goal = goal;
    this.waypoint = waypoint;
    this.tcpInFlange = tcpInFlange;
    length = goal.maxAbsDifference(from);
    double highest = Double.POSITIVE_INFINITY;
    for (int i = 0; i < Joints.COUNT; i++) {
      double part = length == 0 ? 0 : (goal.get(i) - from.get(i)) / length;
      perLength[i] = part;
      highest = Math.min(highest, arm.joints().get(i).maxSpeedRadPerS() / Math.abs(part));
    }
    fastest = highest;
  }

  @Override
  public double length() {
    return length;
  }

  @Override
  public Optional<MotionFailure> sample(
      double at, double rate, double rate2, MotionSample sample) {
    if (at >= length) {
      goal.copyTo(sample.position);
    } else {
      for (int i = 0; i < Joints.COUNT; i++) {
        sample.position[i] = from.get(i) + perLength[i] * at;
      }
    }
    for (int i = 0; i < Joints.COUNT; i++) {
      sample.speed[i] = perLength[i] * rate;
      sample.acceleration[i] = perLength[i] * rate2;
    }
    return Optional.empty();
  }

  @Override
  public Joints begin() {
    return from;
  }

  @Override
  public Joints end() {
    return goal;
  }

  /** How far each joint turns for each rad of the leading one. */
  Joints direction() {
    return Joints.of(perLength);
  }

  @Override
  public Pose waypoint() {
    return waypoint;
  }

  @Override
  public Pose tcpInFlange() {
    return tcpInFlange;
  }

  @Override
  public double lengthWithinEnd(double radiusM) {
    return crossing(waypoint, length, -1, radiusM);
  }

  @Override
  public double lengthWithinBegin(double radiusM) {
    return crossing(pose(0), 0, 1, radiusM);
  }

  /** How far one can go from an end until the TCP is {@code radiusM} away from the pose there. */
  private double crossing(Pose centre, double end, int direction, double radiusM) {
    double inside = 0;
    double outside = 0;
    for (int i = 1; i <= STEPS; i++) {
      outside = i * length / STEPS;
      if (distance(centre, end + direction * outside) > radiusM) {
        break;
      }
      inside = outside;
    }
    for (int i = 0; i < HALVINGS && inside < outside; i++) {
      double middle = 0.5 * (inside + outside);
      if (distance(centre, end + direction * middle) > radiusM) {
        outside = middle;
      } else {
        inside = middle;
      }
    }
    return inside;
  }

  private double distance(Pose centre, double at) {
    return Poses.pointDistance(centre, pose(at));
  }

  private Pose pose(double at) {
    double[] q = new double[Joints.COUNT];
    for (int i = 0; i < Joints.COUNT; i++) {
      q[i] = from.get(i) + perLength[i] * at;
    }
    return forward.tcpPose(Joints.of(q), tcpInFlange);
  }

  @Override
  public double fastestRate() {
    return fastest;
  }
}
