package org.pendant.controller.freedrive;

import org.pendant.models.pose.Pose;

/**
 * Freedrive frame: the frame whose axes the {@link FreeAxes} are. It stays where it is when
 * freedrive begins.
 */
public sealed interface FreedriveFrame {
  /** The base. */
  Base BASE = new Base();

  /** The active tool centre point, as it is turned when freedrive begins. */
  Tool TOOL = new Tool();

  /** The base. */
  record Base() implements FreedriveFrame {}

  /** The active tool centre point, as it is turned when freedrive begins. */
  record Tool() implements FreedriveFrame {}

  /**
   * A feature.
   *
   * @param inBase its pose in the base frame; only how it is turned matters
   */
  record Feature(Pose inBase) implements FreedriveFrame {}
}
