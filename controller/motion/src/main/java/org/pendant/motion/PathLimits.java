package org.pendant.motion;

import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * Path limits: the speed and acceleration along a path that the arm is able to follow, computed
 * once when the path is planned.
 */
@FunctionalInterface
public interface PathLimits {
  /** Keeps nothing back. */
  PathLimits UNLIMITED =
      new PathLimits() {
        @Override
        public PathCaps over(double length, Points points) {
          return PathCaps.NONE;
        }

        @Override
        public PathCaps along(
            ArmDescription arm, ToolCurve curve, double length, Pose tcp, Joints begin) {
          return PathCaps.NONE;
        }
      };

  /** Points of a path, asked for from its start to its end. */
  @FunctionalInterface
  interface Points {
    /**
     * A point for a rate of 1 that does not change.
     *
     * @param at 0 to the length of the path
     * @param sample overwritten
     * @return whether there is such a point, and joint speeds there
     */
    boolean at(double at, MotionSample sample);
  }

  /**
   * The caps for a path.
   *
   * @param length of the path, in its own unit
   */
  PathCaps over(double length, Points points);

  /** Whether what the payload does to the tool is limited. */
  default boolean limitsWrench() {
    return false;
  }

  /**
   * How much of the limits of the tool's wrench a point of a motion takes, 1 for all of one; 0
   * where none is set.
   *
   * @param sample in the motion's own time
   */
  default double wrenchShare(MotionSample sample) {
    return 0;
  }

  /** The caps for a curve of the TCP, asked by a follower of its own. */
  default PathCaps along(
      ArmDescription arm, ToolCurve curve, double length, Pose tcpInFlange, Joints begin) {
    ToolPathFollower follower = new ToolPathFollower(arm, curve, tcpInFlange, begin);
    return over(length, (at, sample) -> follower.sample(at, 1, 0, sample).isEmpty());
  }
}
