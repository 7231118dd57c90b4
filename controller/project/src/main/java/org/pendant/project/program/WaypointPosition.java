package org.pendant.project.program;

import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * Waypoint position: a place that was taught.
 *
 * @param tcp pose of the TCP in the feature, m and rotation vector in rad
 * @param feature {@code Base} or the name of a feature of the installation
 * @param jointsRad how the arm stood
 * @param toolInFlange the TCP that was active, in the flange frame
 */
public record WaypointPosition(Pose tcp, String feature, Joints jointsRad, Pose toolInFlange) {
  /** What the frame of the robot's base is called. */
  public static final String BASE = "Base";

  /** What the frame of the tool is called. */
  public static final String TOOL = "Tool";
}
