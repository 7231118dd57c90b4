package org.pendant.desktop.session;

import static org.pendant.desktop.session.SessionTexts.text;

import org.pendant.controller.state.ControllerState;

/**
 * Program phase: what a program does, in the one word that people read everywhere. It is paused
 * whether an operator, a popup, a stop or the debugger has paused it.
 */
public enum ProgramPhase {
  STOPPED,
  RUNNING,
  PAUSED;

  /** The phase of the program in a snapshot. */
  public static ProgramPhase of(ControllerState state) {
    if (state.debug().held()) {
      return PAUSED;
    }
    return switch (state.program().state()) {
      case STOPPED -> STOPPED;
      case RUNNING -> RUNNING;
      case PAUSED -> PAUSED;
    };
  }

  /** Such as {@code paused}. */
  public String word() {
    return switch (this) {
      case STOPPED -> text("programStopped");
      case RUNNING -> text("programRunning");
      case PAUSED -> text("programPaused");
    };
  }

  /** What stands on the buttons that run a program, or resume one that is paused. */
  public String runWord() {
    return this == PAUSED ? text("resume") : text("run");
  }
}
