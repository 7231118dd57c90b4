package org.pendant.motion;

import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.StraightLine;

/**
 * Tool path: a straight line of the TCP, its orientation turning evenly the shorter way round
 * (manual 15.30).
 *
 * <p>The manual limits the tool's speed only. So that a turn on the spot is finite too, an angle
 * counts as a length of {@code 1 / }{@value #ROTATION_FACTOR} m for each rad where that is longer
 * than the line.
 */
final class ToolPath implements ToolCurvePath {
  /** Angular speed and acceleration, in rad, for one m/s and one m/s². */
  static final double ROTATION_FACTOR = 4;

  /** A line or turn shorter than this is none; the TCP stays where it is. */
  private static final double NOTHING_M = 1e-12;

  private final ArmDescription arm;
  private final StraightLine line;
  private final double length;
  private final Joints begin;
  private final Pose tcpInFlange;
  private final ToolCurve curve;

  /** Made when the path is followed: most paths are only looked at from a blend before. */
  private Optional<ToolPathFollower> follower = Optional.empty();

  private Optional<Joints> end = Optional.empty();
  private final PathLimits pathLimits;
  private Optional<PathCaps> caps = Optional.empty();

  /**
   * A line.
   *
   * @param begin joint positions at its start, rad
   * @param start pose of the TCP there, in the base frame
   * @param goal pose of the TCP at its end, in the base frame
   */
  ToolPath(ArmDescription arm, Joints begin, Pose start, Pose goal, Pose tcpInFlange) {
    this(arm, begin, start, goal, tcpInFlange, PathLimits.UNLIMITED);
  }

  /**
   * A line.
   *
   * @param pathLimits what keeps a move on it within the means of the arm
   */
  ToolPath(
      ArmDescription arm,
      Joints begin,
      Pose start,
      Pose goal,
      Pose tcpInFlange,
      PathLimits pathLimits) {
    this.pathLimits = pathLimits;
    this.arm = arm;
    this.begin = begin;
    this.tcpInFlange = tcpInFlange;
    line = new StraightLine(start, goal);
    double effective = Math.max(line.lengthM(), line.angleRad() / ROTATION_FACTOR);
    length = effective > NOTHING_M ? effective : 0;
    curve = new ToolLine(line, length == 0 ? 1 : length);
  }

  @Override
  public ArmDescription arm() {
    return arm;
  }

  @Override
  public ToolCurve curve() {
    return curve;
  }

  /** The line itself. */
  StraightLine line() {
    return line;
  }

  @Override
  public double length() {
    return length;
  }

  @Override
  public Optional<MotionFailure> sample(double at, double rate, double rate2, MotionSample sample) {
    if (follower.isEmpty()) {
      follower = Optional.of(new ToolPathFollower(arm, curve, tcpInFlange, begin));
    }
    return follower.get().sample(Math.min(at, length), rate, rate2, sample);
  }

  @Override
  public Joints begin() {
    return begin;
  }

  @Override
  public Joints end() {
    if (end.isEmpty()) {
      Pose flange = InverseKinematics.flangeOf(line.to(), tcpInFlange);
      end = Optional.of(new InverseKinematics(arm).closest(flange, begin).orElse(begin));
    }
    return end.get();
  }

  /**
   * By how much the velocity of the TCP changes for each m/s on this line when it continues along
   * another with a part of its rate; turning counts as on a path.
   */
  double bendInto(ToolPath next, double part) {
    Pose was = line.rate();
    Pose will = next.line.rate();
    double f = 1 / length;
    double g = part / next.length;
    double linear =
        size(g * will.x() - f * was.x(), g * will.y() - f * was.y(), g * will.z() - f * was.z());
    double turning =
        size(
            g * will.rx() - f * was.rx(),
            g * will.ry() - f * was.ry(),
            g * will.rz() - f * was.rz());
    return Math.max(linear, turning / ROTATION_FACTOR);
  }

  private static double size(double x, double y, double z) {
    return Math.sqrt(x * x + y * y + z * z);
  }

  @Override
  public Pose waypoint() {
    return line.to();
  }

  @Override
  public Pose tcpInFlange() {
    return tcpInFlange;
  }

  @Override
  public Optional<MotionPath> upTo(double at) {
    Pose goal = at >= length ? line.to() : line.at(at / length);
    return Optional.of(new ToolPath(arm, begin, line.from(), goal, tcpInFlange));
  }

  @Override
  public double lengthWithinEnd(double radiusM) {
    return radiusM >= line.lengthM() ? length : length * (radiusM / line.lengthM());
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

  private PathCaps caps() {
    if (caps.isEmpty()) {
      caps = Optional.of(pathLimits.along(arm, curve, length, tcpInFlange, begin));
    }
    return caps.get();
  }
}
