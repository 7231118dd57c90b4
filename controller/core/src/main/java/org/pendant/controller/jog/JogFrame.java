package org.pendant.controller.jog;

import org.pendant.models.pose.Pose;

/** Jog frame: along whose axes the tool moves. */
public sealed interface JogFrame {
  /** The base of the arm. */
  JogFrame BASE = new Base();

  /** The tool, as it stands when the move begins. */
  JogFrame TOOL = new Tool();

  /** The base of the arm. */
  record Base() implements JogFrame {}

  /** The tool, as it stands when the move begins. */
  record Tool() implements JogFrame {}

  /**
   * Any other frame.
   *
   * @param inBase its pose; only the orientation counts
   */
  record Given(Pose inBase) implements JogFrame {}
}
