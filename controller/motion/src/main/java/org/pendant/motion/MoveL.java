package org.pendant.motion;

import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/** Linear move: a straight line of the TCP from rest to rest (manual 15.30). */
public final class MoveL implements Motion {
  /** Angular speed and acceleration, in rad, for one m/s and one m/s². */
  public static final double ROTATION_FACTOR = ToolPath.ROTATION_FACTOR;

  private final PathMotion motion;

  /**
   * Plans a move.
   *
   * @param from joint positions at its start, rad
   * @param start pose of the TCP at its start, in the base frame
   * @param goal pose of the TCP at its end, in the base frame
   * @param tcpInFlange the TCP offset
   * @param limits in m
   */
  public MoveL(
      ArmDescription arm, Joints from, Pose start, Pose goal, Pose tcpInFlange, MoveLimits limits) {
    motion = MovePlanner.alone(new ToolPath(arm, from, start, goal, tcpInFlange), limits);
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
