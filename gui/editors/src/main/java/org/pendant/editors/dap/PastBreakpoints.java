package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import org.pendant.recording.RecordedCondition;
import org.pendant.recording.RecordedStep;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.PauseReason;

/** Past breakpoints: which steps of a recording the breakpoints that are set now would stop. */
final class PastBreakpoints {
  private final SortedMap<Integer, Breakpoint> byStatement;
  private final Map<String, RecordedCondition> conditions = new HashMap<>();
  private Optional<Breakpoint> untold = Optional.empty();

  /**
   * Of breakpoints.
   *
   * @param byStatement each by the line of its statement
   */
  PastBreakpoints(SortedMap<Integer, Breakpoint> byStatement) {
    this.byStatement = byStatement;
  }

  Set<Integer> lines() {
    return byStatement.keySet();
  }

  /** Whether one would stop a step to one of the lines. */
  boolean stop(RecordedStep step) {
    Breakpoint at = byStatement.get(step.line());
    if (at == null || at.logs()) {
      return false;
    }
    boolean stopped =
        step.stop().filter(stop -> stop.reason() instanceof PauseReason.AtBreakpoint).isPresent();
    if (stopped) {
      return true;
    }
    Optional<Boolean> holds =
        conditions.computeIfAbsent(at.condition(), RecordedCondition::new).holds(step.variables());
    if (holds.isEmpty()) {
      untold = Optional.of(at);
    }
    return holds.orElse(false);
  }

  /** What has come of a search that these stopped nowhere, and what it could not find out. */
  String said(String found) {
    return untold.map(each -> found + "; " + text("conditionUnknown", each.line())).orElse(found);
  }
}
