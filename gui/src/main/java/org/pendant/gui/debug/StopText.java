package org.pendant.gui.debug;

import java.util.function.IntUnaryOperator;
import org.pendant.language.source.ByteText;
import org.pendant.script.debug.DebugState;
import org.pendant.script.debug.StopReason;

/** Why a program is held, as people read it. */
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
      case StopReason.AtBreakpoint at ->
          "Breakpoint on line "
              + now.applyAsInt(at.line())
              + (at.hits() > 1 ? ", hit " + at.hits() : "");
      case StopReason.ConditionFailed failed ->
          "The condition of the breakpoint on line "
              + now.applyAsInt(failed.line())
              + " failed: "
              + ByteText.decoded(failed.message());
      case StopReason.Stepped() -> "Stepped to line " + line;
      case StopReason.PauseRequested() -> "Held on request on line " + line;
      case StopReason.Failed failed ->
          "Failed on line "
              + line
              + ": "
              + ByteText.decoded(failed.failure().message())
              + ". The program ends when it goes on";
    };
  }

  /** What is said behind the line itself. */
  static String atLine(DebugState.Stop stop) {
    return switch (stop.reason()) {
      case StopReason.AtBreakpoint at -> at.hits() > 1 ? "hit " + at.hits() : "";
      case StopReason.ConditionFailed failed ->
          "The condition failed: " + ByteText.decoded(failed.message());
      case StopReason.Stepped(), StopReason.PauseRequested() -> "";
      case StopReason.Failed failed -> ByteText.decoded(failed.failure().message());
    };
  }
}
