package org.pendant.motion;

import java.util.Optional;
import org.pendant.models.pose.Pose;

/** Tool blend motion: leads from one straight line of the TCP to the next. */
final class ToolBlendMotion implements Motion {
  private final ToolPathFollower follower;
  private final double durationS;
  private final Pose waypoint;

  /**
   * A motion.
   *
   * @param follower of a curve whose parameter is the time, s
   * @param waypoint where the TCP goes after the blend, in the base frame
   */
  ToolBlendMotion(ToolPathFollower follower, double durationS, Pose waypoint) {
    this.follower = follower;
    this.durationS = durationS;
    this.waypoint = waypoint;
  }

  @Override
  public double durationS() {
    return durationS;
  }

  @Override
  public Optional<MotionFailure> sample(double timeS, MotionSample sample) {
    return follower.sample(timeS, 1, 0, sample);
  }

  @Override
  public Optional<Pose> waypoint() {
    return Optional.of(waypoint);
  }
}
