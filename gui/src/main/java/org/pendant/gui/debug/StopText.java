package org.pendant.gui.debug;

import org.pendant.controller.debug.DebugState;
import org.pendant.controller.debug.StopReason;
import org.pendant.language.source.ByteText;

/** Why a program is held, as people read it. */
final class StopText {
  private StopText() {}

  static String of(DebugState.Stop stop) {
    return switch (stop.reason()) {
      case StopReason.AtBreakpoint at ->
          "Breakpoint on line " + at.line() + (at.hits() > 1 ? ", hit " + at.hits() : "");
      case StopReason.ConditionFailed failed ->
          "The condition of the breakpoint on line "
              + failed.line()
              + " failed: "
              + ByteText.decoded(failed.message());
      case StopReason.Stepped() -> "Stepped to line " + stop.line();
      case StopReason.PauseRequested() -> "Held on request on line " + stop.line();
      case StopReason.Failed failed ->
          "Failed on line "
              + stop.line()
              + ": "
              + ByteText.decoded(failed.failure().message())
              + ". The program ends when it goes on";
    };
  }
}
