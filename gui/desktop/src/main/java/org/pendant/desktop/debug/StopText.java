package org.pendant.desktop.debug;

import java.util.function.IntUnaryOperator;
import org.pendant.language.source.ByteText;
import org.pendant.script.debug.DebugState;
import org.pendant.script.debug.PauseReason;

/** Pause text: why a program is paused, as people read it. */
final class StopText {
  private StopText() {}

  /**
   * The reason, with the lines of the text as it is now.
   *
   * @param now the present line of a line of the running text
   */
  static String of(DebugState.Stop stop, IntUnaryOperator now) {
    int line = now.applyAsInt(stop.line());
    return switch (stop.reason()) {
      case PauseReason.AtBreakpoint at ->
          "Breakpoint on line "
              + now.applyAsInt(at.line())
              + (at.hits() > 1 ? ", hit " + at.hits() : "");
      case PauseReason.ConditionFailed failed ->
          "The condition of the breakpoint on line "
              + now.applyAsInt(failed.line())
              + " failed: "
              + ByteText.decoded(failed.message());
      case PauseReason.Stepped() -> "Stepped to line " + line;
      case PauseReason.PauseRequested() -> "Paused at line " + line;
      case PauseReason.Failed failed ->
          "Failed on line "
              + line
              + ": "
              + ByteText.decoded(failed.failure().message())
              + ". The program ends when it continues";
    };
  }

  /** What is said behind the line itself. */
  static String atLine(DebugState.Stop stop) {
    return switch (stop.reason()) {
      case PauseReason.AtBreakpoint at -> at.hits() > 1 ? "hit " + at.hits() : "";
      case PauseReason.ConditionFailed failed ->
          "The condition failed: " + ByteText.decoded(failed.message());
      case PauseReason.Stepped(), PauseReason.PauseRequested() -> "";
      case PauseReason.Failed failed -> ByteText.decoded(failed.failure().message());
    };
  }
}
