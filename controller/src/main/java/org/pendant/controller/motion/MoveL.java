package org.pendant.controller.motion;

import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.StraightLine;

/**
 * A straight line of the TCP, its orientation turning evenly the shorter way round (manual 15.30).
 *
 * <p>The manual limits the tool's speed only. So that a turn on the spot is finite too, the angle
 * gets a profile of its own with {@value #ROTATION_FACTOR} times the numbers, in rad; the slower of
 * the two profiles moves both.
 */
public final class MoveL implements Motion {
  /** Angular speed and acceleration, in rad, for one m/s and one m/s². */
  public static final double ROTATION_FACTOR = 4;

  private final TrapezoidProfile profile;
  private final ToolPathFollower follower;
  private final Pose goal;
  private final double scale;

  /**
   * Plans a move.
   *
   * @param from joint positions at its begin, rad
   * @param start pose of the TCP at its begin, in the base frame
   * @param goal pose of the TCP at its end, in the base frame
   * @param tcpInFlange the TCP offset
   * @param limits in m
   */
  public MoveL(
      ArmDescription arm, Joints from, Pose start, Pose goal, Pose tcpInFlange, MoveLimits limits) {
    this.goal = goal;
    StraightLine line = new StraightLine(start, goal);
    follower = new ToolPathFollower(arm, line, tcpInFlange, from);
    profile = profile(line, limits);
    scale = profile.distance() == 0 ? 0 : 1 / profile.distance();
  }

  private static TrapezoidProfile profile(StraightLine line, MoveLimits limits) {
    MoveLimits turning =
        new MoveLimits(
            ROTATION_FACTOR * limits.acceleration(),
            ROTATION_FACTOR * limits.speed(),
            limits.durationS());
    TrapezoidProfile along = limits.over(line.lengthM());
    TrapezoidProfile around = turning.over(line.angleRad());
    if (limits.timed()) {
      return line.lengthM() > 0 ? along : around;
    }
    return along.durationS() >= around.durationS() ? along : around;
  }

  @Override
  public double durationS() {
    return profile.durationS();
  }

  @Override
  public Optional<MotionFailure> sample(double timeS, MotionSample sample) {
    double fraction = timeS >= profile.durationS() ? 1 : scale * profile.position(timeS);
    return follower.sample(
        fraction, scale * profile.speed(timeS), scale * profile.acceleration(timeS), sample);
  }

  @Override
  public Optional<Pose> waypoint() {
    return Optional.of(goal);
  }
}
