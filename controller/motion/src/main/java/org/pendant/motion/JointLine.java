package org.pendant.motion;

import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Straight line in joint space: all joints turn in proportion (manual 15.29). Its unit is rad of
 * the leading axis, the joint that turns farthest.
 */
final class JointLine implements MotionPath {
  /** Steps in which the line is looked at for where it crosses a sphere, rad. */
  private static final double STEP_RAD = 0.1;

  /** How close to the sphere a crossing is found, m; inside. */
  private static final double NEAR_M = 1e-10;

  /** When the search ends in any case, as part of the line. */
  private static final double NEAR = 1e-13;

  private static final int MAX_TRIES = 60;

  private final ArmDescription arm;
  private final ForwardKinematics forward;
  private final Joints from;
  private final Joints goal;
  private final Pose waypoint;
  private final Pose tcpInFlange;
  private final double length;
  private final double fastest;
  private final double[] perLength = new double[Joints.COUNT];
  private final double[] q = new double[Joints.COUNT];
  private final double[] flange = new double[Transforms.SIZE];
  private final double[] tcp = new double[Transforms.SIZE];
  private final double[] tcpInBase = new double[Transforms.SIZE];
  private final PathLimits pathLimits;
  private Optional<PathCaps> caps = Optional.empty();

  /**
   * A line.
   *
   * @param from joint positions at its start, rad
   * @param goal joint positions at its end, rad, within the ranges of the arm
   * @param waypoint pose of the TCP at its end, in the base frame
   */
  JointLine(ArmDescription arm, Joints from, Joints goal, Pose waypoint, Pose tcpInFlange) {
    this(arm, from, goal, waypoint, tcpInFlange, PathLimits.UNLIMITED);
  }

  /**
   * A line.
   *
   * @param pathLimits what keeps a move on it within the means of the arm
   */
  JointLine(
      ArmDescription arm,
      Joints from,
      Joints goal,
      Pose waypoint,
      Pose tcpInFlange,
      PathLimits pathLimits) {
    this.pathLimits = pathLimits;
    this.arm = arm;
    forward = new ForwardKinematics(arm);
    this.from = from;
    this.goal = goal;
    this.waypoint = waypoint;
    this.tcpInFlange = tcpInFlange;
    Transforms.of(tcpInFlange, tcp);
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
  public Optional<MotionFailure> sample(double at, double rate, double rate2, MotionSample sample) {
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
  public Optional<MotionPath> upTo(double at) {
    double[] cut = new double[Joints.COUNT];
    for (int i = 0; i < Joints.COUNT; i++) {
      cut[i] = from.get(i) + perLength[i] * at;
    }
    Joints end = at >= length ? goal : Joints.of(cut);
    return Optional.of(
        new JointLine(arm, from, end, forward.tcpPose(end, tcpInFlange), tcpInFlange));
  }

  @Override
  public double lengthWithinEnd(double radiusM) {
    return crossing(waypoint, length, -1, radiusM);
  }

  @Override
  public double lengthWithinBegin(double radiusM) {
    return crossing(forward.tcpPose(from, tcpInFlange), 0, 1, radiusM);
  }

  /** How far one can go from an end until the TCP is {@code radiusM} away from the pose there. */
  private double crossing(Pose centre, double end, int direction, double radiusM) {
    if (radiusM == 0) {
      return 0;
    }
    int steps = (int) Math.ceil(Math.max(1, length / STEP_RAD));
    double inside = 0;
    double beneath = -radiusM;
    for (int i = 1; i <= steps; i++) {
      double outside = i * length / steps;
      double beyond = distance(centre, end + direction * outside) - radiusM;
      if (beyond > 0) {
        return between(
            inside,
            beneath,
            outside,
            beyond,
            at -> distance(centre, end + direction * at) - radiusM);
      }
      inside = outside;
      beneath = beyond;
    }
    return inside;
  }

  /**
   * The last point found below a zero, by false position in the Illinois form. (M. Dowell and P.
   * Jarratt, "A modified regula falsi method", BIT 11, 1971.)
   */
  private double between(
      double low, double lowValue, double high, double highValue, DoubleUnaryOperator function) {
    double a = low;
    double fa = lowValue;
    double b = high;
    double fb = highValue;
    double found = low;
    int side = 0;
    for (int i = 0; i < MAX_TRIES && b - a > NEAR * length; i++) {
      double x = (a * fb - b * fa) / (fb - fa);
      double f = function.applyAsDouble(x);
      if (f > 0) {
        b = x;
        fb = f;
        fa = side > 0 ? fa / 2 : fa;
        side = 1;
      } else {
        a = x;
        found = x;
        fa = f;
        fb = side < 0 ? fb / 2 : fb;
        side = -1;
        if (f > -NEAR_M) {
          return found;
        }
      }
    }
    return found;
  }

  private double distance(Pose centre, double at) {
    for (int i = 0; i < Joints.COUNT; i++) {
      q[i] = from.get(i) + perLength[i] * at;
    }
    forward.flange(q, flange);
    Transforms.multiply(flange, tcp, tcpInBase);
    double x = tcpInBase[9] - centre.x();
    double y = tcpInBase[10] - centre.y();
    double z = tcpInBase[11] - centre.z();
    return Math.sqrt(x * x + y * y + z * z);
  }

  @Override
  public PathLimits pathLimits() {
    return pathLimits;
  }

  @Override
  public double fastestRate() {
    return Math.min(fastest, caps().rate());
  }

  @Override
  public double strongestRate2() {
    return caps().rate2();
  }

  private PathCaps caps() {
    if (caps.isEmpty()) {
      caps = Optional.of(pathLimits.over(length, (at, to) -> sample(at, 1, 0, to).isEmpty()));
    }
    return caps.get();
  }
}
