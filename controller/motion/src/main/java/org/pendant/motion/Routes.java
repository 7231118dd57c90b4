package org.pendant.motion;

import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * Route planner: the paths that moves take, whether the arm can follow them to their ends or not.
 */
public final class Routes {
  private Routes() {}

  /**
   * A straight line in joint space.
   *
   * @param goal joint positions at its end, rad
   * @param waypoint pose of the TCP at its end, in the base frame
   */
  public static MotionPath joints(
      ArmDescription arm, Joints from, Joints goal, Pose waypoint, Pose tcpInFlange) {
    return new JointLine(arm, from, goal, waypoint, tcpInFlange);
  }

  /**
   * A straight line in joint space that an arm has limited means for.
   *
   * @param goal joint positions at its end, rad
   * @param waypoint pose of the TCP at its end, in the base frame
   */
  public static MotionPath joints(
      ArmDescription arm,
      Joints from,
      Joints goal,
      Pose waypoint,
      Pose tcpInFlange,
      PathLimits pathLimits) {
    return new JointLine(arm, from, goal, waypoint, tcpInFlange, pathLimits);
  }

  /**
   * A straight line of the TCP that an arm has limited means for.
   *
   * @param start pose of the TCP at its start, in the base frame
   * @param goal pose of the TCP at its end, in the base frame
   */
  public static MotionPath line(
      ArmDescription arm,
      Joints from,
      Pose start,
      Pose goal,
      Pose tcpInFlange,
      PathLimits pathLimits) {
    return new ToolPath(arm, from, start, goal, tcpInFlange, pathLimits);
  }

  /**
   * A straight line of the TCP.
   *
   * @param start pose of the TCP at its start, in the base frame
   * @param goal pose of the TCP at its end, in the base frame
   */
  public static MotionPath line(
      ArmDescription arm, Joints from, Pose start, Pose goal, Pose tcpInFlange) {
    return new ToolPath(arm, from, start, goal, tcpInFlange);
  }
}
