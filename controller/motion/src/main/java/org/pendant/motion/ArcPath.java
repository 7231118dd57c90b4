package org.pendant.motion;

import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * Arc path: the TCP moves along a circular arc (manual 15.28). As on a straight line, an angle of
 * the tool counts as a length where that is longer, unless the tool only follows the tangent.
 */
final class ArcPath implements ToolCurvePath {
  /** Farthest turn of the tool between two points that joints are followed over, rad. */
  private static final double STEP_RAD = 0.2;

  private final ArmDescription arm;
  private final Arc arc;
  private final ToolCurve curve;
  private final double length;
  private final double step;
  private final Joints begin;
  private final Pose waypoint;
  private final Pose tcpInFlange;
  private final PathLimits pathLimits;
  private final ToolPathFollower follower;
  private final MotionSample between = new MotionSample();
  private double last;
  private Optional<PathCaps> caps = Optional.empty();
  private Optional<Joints> end = Optional.empty();

  /**
   * An arc.
   *
   * @param begin joint positions at its start, rad
   * @param length of the curve, in the unit of its parameter, above 0
   * @param turnRad how far direction or tool turn on it, the larger of both
   * @param waypoint pose of the TCP at its end, in the base frame
   */
  ArcPath(
      ArmDescription arm,
      Joints begin,
      Arc arc,
      ToolCurve curve,
      double length,
      double turnRad,
      Pose waypoint,
      Pose tcpInFlange,
      PathLimits pathLimits) {
    this.arm = arm;
    this.begin = begin;
    this.arc = arc;
    this.curve = curve;
    this.length = length;
    this.waypoint = waypoint;
    this.tcpInFlange = tcpInFlange;
    this.pathLimits = pathLimits;
    step = length / Math.max(1, Math.ceil(turnRad / STEP_RAD));
    follower = new ToolPathFollower(arm, curve, tcpInFlange, begin);
  }

  @Override
  public ArmDescription arm() {
    return arm;
  }

  @Override
  public ToolCurve curve() {
    return curve;
  }

  @Override
  public double length() {
    return length;
  }

  @Override
  public Optional<MotionFailure> sample(double at, double rate, double rate2, MotionSample sample) {
    double goal = Math.min(at, length);
    // joints follow the curve: a jump along it might end in another turn of a wrist
    while (Math.abs(goal - last) > 1.5 * step) {
      last += Math.copySign(step, goal - last);
      Optional<MotionFailure> failure = follower.sample(last, 0, 0, between);
      if (failure.isPresent()) {
        return failure;
      }
    }
    last = goal;
    return follower.sample(goal, rate, rate2, sample);
  }

  @Override
  public Joints begin() {
    return begin;
  }

  @Override
  public Joints end() {
    if (end.isEmpty()) {
      ToolPathFollower ahead = new ToolPathFollower(arm, curve, tcpInFlange, begin);
      long steps = Math.round(length / step);
      MotionSample at = new MotionSample();
      begin.copyTo(at.position);
      for (int i = 1; i <= steps; i++) {
        if (ahead.sample(length * i / steps, 0, 0, at).isPresent()) {
          break;
        }
      }
      end = Optional.of(at.positionRad());
    }
    return end.get();
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
    double half = radiusM / (2 * arc.radius());
    double within = half < 1 ? 2 * arc.radius() * Math.asin(half) : arc.length();
    return length * Math.min(1, within / arc.length());
  }

  @Override
  public double lengthWithinBegin(double radiusM) {
    return lengthWithinEnd(radiusM);
  }

  @Override
  public PathLimits pathLimits() {
    return pathLimits;
  }

  @Override
  public double fastestRate() {
    return caps().rate();
  }

  @Override
  public double strongestRate2() {
    return caps().rate2();
  }

  @Override
  public double bending() {
    double metres = arc.length() / length;
    return metres * metres / arc.radius();
  }

  private PathCaps caps() {
    if (caps.isEmpty()) {
      caps = Optional.of(pathLimits.along(arm, curve, length, tcpInFlange, begin));
    }
    return caps.get();
  }
}
