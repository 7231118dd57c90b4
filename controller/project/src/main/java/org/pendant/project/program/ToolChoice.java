package org.pendant.project.program;

/** Tool choice: which TCP a move is about. */
public sealed interface ToolChoice {

  /** The one that is active when the move begins. */
  record Active() implements ToolChoice {}

  /** None: the flange. */
  record Flange() implements ToolChoice {}

  /** One of the installation, which the move makes the active one. */
  record Named(String name) implements ToolChoice {}
}
