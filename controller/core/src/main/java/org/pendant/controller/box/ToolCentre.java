package org.pendant.controller.box;

import org.pendant.models.pose.Pose;

/**
 * Tool centre point that is active (manual 16.53).
 *
 * @param inFlange its pose in the flange frame, m and rad
 * @param name bytes, one {@code char} a byte; may be empty
 */
public record ToolCentre(Pose inFlange, String name) {
  /** The flange itself. */
  public static final ToolCentre FLANGE = new ToolCentre(Pose.ZERO, "");
}
