package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

import java.util.function.IntFunction;
import org.pendant.kit.text.Messages;
import org.pendant.language.source.ByteText;
import org.pendant.script.debug.DebugState;
import org.pendant.script.debug.PauseReason;

/** Pause text: why a program is paused, as people read it. */
final class StopText {
  private StopText() {}

  /**
   * The reason.
   *
   * @param places what a line of the running text is called within a sentence
   */
  static String of(DebugState.Stop stop, IntFunction<String> places) {
    String place = places.apply(stop.line());
    return switch (stop.reason()) {
      case PauseReason.AtBreakpoint at ->
          at.hits() > 1
              ? text("breakpointOnHit", places.apply(at.line()), at.hits())
              : text("breakpointOn", places.apply(at.line()));
      case PauseReason.ConditionFailed failed ->
          text(
              "theConditionOfTheBreakpointOn",
              places.apply(failed.line()),
              ByteText.decoded(failed.message()));
      case PauseReason.Stepped() -> text("steppedTo", place);
      case PauseReason.PauseRequested() -> text("pausedAt", place);
      case PauseReason.Failed failed ->
          text("failedOnTheProgramEnds", place, ByteText.decoded(failed.failure().message()));
    };
  }

  /** What is said behind the line itself. */
  static String atLine(DebugState.Stop stop) {
    return switch (stop.reason()) {
      case PauseReason.AtBreakpoint at -> at.hits() > 1 ? text("hitTimes", at.hits()) : "";
      case PauseReason.ConditionFailed failed ->
          text("theConditionFailed", ByteText.decoded(failed.message()));
      case PauseReason.Stepped(), PauseReason.PauseRequested() -> "";
      case PauseReason.Failed failed ->
          Messages.shown(ByteText.decoded(failed.failure().message()));
    };
  }
}
