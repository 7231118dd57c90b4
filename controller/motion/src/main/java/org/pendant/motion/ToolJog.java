package org.pendant.motion;

import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.StraightLine;
import org.pendant.motion.profile.Profile;
import org.pendant.motion.profile.ProfileLimits;

/**
 * Tool jog: the TCP moves along a straight line, or the tool about an axis through it, until a
 * client ends it.
 */
public final class ToolJog implements Motion {
  /** Farther than any arm reaches, m, and more turns than anybody waits for, rad. */
  private static final double FARTHEST = 1000;

  private final Profile profile;
  private final ToolPathFollower follower;

  /**
   * Plans a move.
   *
   * @param from joint positions at its start, rad
   * @param start pose of the TCP at its start, in the base frame
   * @param twistInBase what the TCP does per unit of the way: 1 m along an axis or 1 rad about one
   * @param tcpInFlange the TCP offset
   * @param limits in m; for a turn {@value MoveL#ROTATION_FACTOR} times the numbers, in rad
   */
  public ToolJog(
      ArmDescription arm,
      Joints from,
      Pose start,
      Pose twistInBase,
      Pose tcpInFlange,
      MoveLimits limits) {
    StraightLine line = new StraightLine(start, Poses.add(twistInBase, start));
    follower = new ToolPathFollower(arm, new ToolLine(line, 1), tcpInFlange, from);
    double factor = line.lengthM() > 0 ? 1 : MoveL.ROTATION_FACTOR;
    profile =
        ProfileLimits.of(factor * limits.speed(), factor * limits.acceleration()).over(FARTHEST);
  }

  @Override
  public double durationS() {
    return profile.durationS();
  }

  @Override
  public Optional<MotionFailure> sample(double timeS, MotionSample sample) {
    return follower.sample(
        profile.position(timeS), profile.speed(timeS), profile.acceleration(timeS), sample);
  }

  @Override
  public Optional<Pose> waypoint() {
    return Optional.empty();
  }
}
