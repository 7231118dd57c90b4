package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

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
          at.hits() > 1
              ? text("breakpointOnLineHit", now.applyAsInt(at.line()), at.hits())
              : text("breakpointOnLine", now.applyAsInt(at.line()));
      case PauseReason.ConditionFailed failed ->
          text(
              "theConditionOfTheBreakpointOn",
              now.applyAsInt(failed.line()),
              ByteText.decoded(failed.message()));
      case PauseReason.Stepped() -> text("steppedToLine", line);
      case PauseReason.PauseRequested() -> text("pausedAtLine", line);
      case PauseReason.Failed failed ->
          text("failedOnLineTheProgramEnds", line, ByteText.decoded(failed.failure().message()));
    };
  }

  /** What is said behind the line itself. */
  static String atLine(DebugState.Stop stop) {
    return switch (stop.reason()) {
      case PauseReason.AtBreakpoint at -> at.hits() > 1 ? text("hitTimes", at.hits()) : "";
      case PauseReason.ConditionFailed failed ->
          text("theConditionFailed", ByteText.decoded(failed.message()));
      case PauseReason.Stepped(), PauseReason.PauseRequested() -> "";
      case PauseReason.Failed failed -> ByteText.decoded(failed.failure().message());
    };
  }
}
