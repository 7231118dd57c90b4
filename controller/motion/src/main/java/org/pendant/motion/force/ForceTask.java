package org.pendant.motion.force;

import java.util.Collections;
import java.util.List;
import org.pendant.models.pose.Pose;

/**
 * Force mode task: axes, wrench and limits that force mode is asked for (manual 15.12).
 *
 * @param kind how the task frame is read
 * @param taskFrame in the base frame; of {@link FrameKind#TOOL} it does not count
 * @param axes one for each of x, y, z, rx, ry, rz of the task frame; rotations are about the TCP
 */
public record ForceTask(FrameKind kind, Pose taskFrame, List<ForceAxis> axes) {
  /** Axes of a task frame. */
  public static final int AXES = 6;

  private static final ForceAxis RIGID = new ForceAxis(false, 0, Double.POSITIVE_INFINITY);

  /**
   * Keeps the axes as they are.
   *
   * @throws IllegalArgumentException if there are not six of them
   */
  public ForceTask {
    axes = List.copyOf(axes);
    if (axes.size() != AXES) {
      throw new IllegalArgumentException("force task: " + axes.size() + " axes, must be six");
    }
  }

  /** Nothing gives way. */
  static ForceTask rigid() {
    return new ForceTask(FrameKind.FIXED, Pose.ZERO, Collections.nCopies(AXES, RIGID));
  }

  /**
   * Presses along the z axis of the TCP only (manual 15.43).
   *
   * @param forceN along z of the TCP
   * @param speedMPerS the fastest that the TCP may go along z, at least 0
   */
  public static ForceTask screwDriving(double forceN, double speedMPerS) {
    ForceAxis z = new ForceAxis(true, forceN, speedMPerS);
    return new ForceTask(FrameKind.TOOL, Pose.ZERO, List.of(RIGID, RIGID, z, RIGID, RIGID, RIGID));
  }
}
