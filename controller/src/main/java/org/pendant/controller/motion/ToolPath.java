package org.pendant.controller.motion;

import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.StraightLine;

/**
 * A straight line of the TCP, its orientation turning evenly the shorter way round (manual 15.30).
 *
 * <p>The manual limits the tool's speed only. So that a turn on the spot is finite too, an angle
 * counts as a length of {@code 1 / }{@value #ROTATION_FACTOR} m for each rad where that is longer
 * than the line.
 */
final class ToolPath implements MotionPath {
  /** Angular speed and acceleration, in rad, for one m/s and one m/s². */
  static final double ROTATION_FACTOR = 4;

  /** A line or turn shorter than this is none; the TCP stays where it is. */
  private static final double NOTHING_M = 1e-12;

  private final ArmDescription arm;
  private final StraightLine line;
  private final double length;
  private final Joints begin;
  private final Pose tcpInFlange;
  private final ToolPathFollower follower;

  /**
   * A line.
   *
   * @param begin joint positions at its begin, rad
   * @param start pose of the TCP there, in the base frame
   * @param goal pose of the TCP at its end, in the base frame
   */
  ToolPath(ArmDescription arm, Joints begin, Pose start, Pose goal, Pose tcpInFlange) {
    this.arm = arm;
    this.begin = begin;
    this.tcpInFlange = tcpInFlange;
    line = new StraightLine(start, goal);
    double effective = Math.max(line.lengthM(), line.angleRad() / ROTATION_FACTOR);
    length = effective > NOTHING_M ? effective : 0;
    follower =
        new ToolPathFollower(
            arm, new ToolLine(line, length == 0 ? 1 : length), tcpInFlange, begin);
  }

  ArmDescription arm() {
    return arm;
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
  public Optional<MotionFailure> sample(
      double at, double rate, double rate2, MotionSample sample) {
    return follower.sample(Math.min(at, length), rate, rate2, sample);
  }

  @Override
  public Joints begin() {
    return begin;
  }

  @Override
  public Joints end() {
    Pose flange = InverseKinematics.flangeOf(line.to(), tcpInFlange);
    return new InverseKinematics(arm).closest(flange, begin).orElse(begin);
  }

  /**
   * By how much the velocity of the TCP changes for each m/s on this line when it goes on along
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
  public double lengthWithinEnd(double radiusM) {
    return radiusM >= line.lengthM() ? length : length * (radiusM / line.lengthM());
  }

  @Override
  public double lengthWithinBegin(double radiusM) {
    return lengthWithinEnd(radiusM);
  }

  @Override
  public double fastestRate() {
    return Double.POSITIVE_INFINITY;
  }
}
