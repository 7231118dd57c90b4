package org.pendant.motion;

import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * Joint move: a straight line in joint space from rest to rest; all joints start and stop together,
 * in proportion (manual 15.29).
 *
 * <p>Speed and acceleration are those of the leading axis, the joint that turns farthest. A speed
 * that would drive any joint beyond its limit is lowered beforehand, a duration that would is
 * stretched.
 */
public final class MoveJ implements Motion {
  private final PathMotion motion;

  /**
   * Plans a move.
   *
   * @param from joint positions at its start, rad
   * @param goal joint positions at its end, rad, within the ranges of the arm
   * @param waypoint pose of the TCP at its end, in the base frame
   * @param limits in rad
   */
  public MoveJ(ArmDescription arm, Joints from, Joints goal, Pose waypoint, MoveLimits limits) {
    MotionPath path = new JointLine(arm, from, goal, waypoint, Pose.ZERO);
    motion = MovePlanner.alone(path, limits);
  }

  @Override
  public double durationS() {
    return motion.durationS();
  }

  @Override
  public Optional<MotionFailure> sample(double timeS, MotionSample sample) {
    return motion.sample(timeS, sample);
  }

  @Override
  public Optional<Pose> waypoint() {
    return motion.waypoint();
  }
}
