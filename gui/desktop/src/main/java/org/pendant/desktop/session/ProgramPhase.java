package org.pendant.desktop.session;

import java.util.Locale;
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
    return name().toLowerCase(Locale.ROOT);
  }

  /** What stands on the buttons that run a program, or resume one that is paused. */
  public String runWord() {
    return this == PAUSED ? "Resume" : "Run";
  }
}
