package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeSet;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.editor.BreakpointListener;
import org.pendant.desktop.editor.BreakpointMark;
import org.pendant.desktop.editor.Execution;
import org.pendant.desktop.editor.LineIcon;
import org.pendant.desktop.editor.ScriptEditor;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.BreakpointState;

/**
 * Editor link: keeps what the editor shows beside its lines and what the debugger knows the same.
 */
public final class EditorLink implements BreakpointListener {
  private final ScriptEditor editor;
  private final DebugPresenter debug;
  private final OpenBreakpoints openBreakpoints;
  private final Programs programs;

  /** Connects both. */
  public EditorLink(ScriptEditor editor, DebugPresenter debug, Programs programs) {
    this.editor = editor;
    this.debug = debug;
    this.programs = programs;
    openBreakpoints = debug.breakpoints();
    openBreakpoints.setMarks(editor::toggleBreakpoint);
    openBreakpoints.addListener(this::showMarks);
    editor.setBreakpointMemory(this::lines);
    editor.addBreakpointListener(this);
    showMarks();
  }

  private SortedSet<Integer> lines(ProgramDocument program) {
    SortedSet<Integer> lines = new TreeSet<>();
    openBreakpoints.all(program).forEach(each -> lines.add(each.line()));
    return lines;
  }

  @Override
  public void breakpointsMoved(ProgramDocument program, SortedMap<Integer, Integer> moves) {
    openBreakpoints.linesMoved(program, moves);
  }

  @Override
  public void breakpointsChanged(ProgramDocument program, SortedSet<Integer> lines) {
    openBreakpoints.linesChanged(program, lines);
  }

  /** A program is about to be started: the debugger gets its breakpoints. */
  public void beforeRun(ProgramDocument program, RunScript script) {
    editor.followAgain();
    openBreakpoints.linesChanged(program, editor.breakpoints(program));
    openBreakpoints.beforeRun(program, script);
  }

  /**
   * A program that is none of the user's has started.
   *
   * @param received its text as it is shown, if it is
   */
  public void strangerStarted(Optional<ProgramDocument> received) {
    openBreakpoints.started().ifPresent(program -> editor.setExecution(program, Execution.NONE));
    openBreakpoints.strangerStarted(received);
  }

  /** Shows where the program is. */
  public void follow(ControllerState state) {
    openBreakpoints
        .started()
        .ifPresent(program -> editor.setExecution(program, debug.execution(state)));
  }

  private void showMarks() {
    for (ProgramDocument program : programs.all()) {
      Map<Integer, BreakpointMark> marks = new HashMap<>();
      for (Breakpoint each : openBreakpoints.all(program)) {
        long hits = openBreakpoints.state(program, each).map(BreakpointState::hits).orElse(0L);
        marks.put(each.line(), mark(each, hits));
      }
      editor.showBreakpoints(program, marks);
    }
  }

  /** How a breakpoint looks. */
  public static LineIcon.Kind kind(Breakpoint breakpoint) {
    boolean conditional = !breakpoint.condition().isEmpty() || !breakpoint.hits().always();
    return breakpoint.logs()
        ? LineIcon.Kind.LOG
        : conditional ? LineIcon.Kind.CONDITIONAL : LineIcon.Kind.STOP;
  }

  static BreakpointMark mark(Breakpoint breakpoint, long hits) {
    String about =
        breakpoint.logs()
            ? text(breakpoint.enabled() ? "logsHere" : "wouldLogHere", breakpoint.message())
            : text(breakpoint.enabled() ? "stopsHere" : "wouldStopHere");
    if (!breakpoint.condition().isEmpty()) {
      about = text("markWithCondition", about, breakpoint.condition());
    }
    if (!breakpoint.hits().always()) {
      about = text("markWithHitRule", about, breakpoint.hits().words());
    }
    if (hits > 0) {
      about = hits == 1 ? text("markHitOnce", about) : text("markHitTimes", about, hits);
    }
    return new BreakpointMark(breakpoint.enabled(), kind(breakpoint), about);
  }
}
