package org.pendant.gui.shell;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.state.ControllerState;
import org.pendant.gui.debug.BreakpointsView;
import org.pendant.gui.debug.CallStackView;
import org.pendant.gui.debug.DebugActions;
import org.pendant.gui.debug.DebugPresenter;
import org.pendant.gui.debug.VariablesView;
import org.pendant.gui.debug.WatchesView;
import org.pendant.gui.editor.OutlineView;
import org.pendant.gui.editor.PlacesView;
import org.pendant.gui.editor.ProblemsView;
import org.pendant.gui.editor.ScriptEditor;
import org.pendant.gui.io.IoView;
import org.pendant.gui.log.LogView;
import org.pendant.gui.move.MoveView;
import org.pendant.gui.plot.PlotView;
import org.pendant.gui.session.ProgramDocument;
import org.pendant.gui.session.Programs;
import org.pendant.gui.shell.dock.Side;
import org.pendant.gui.shell.look.Glyph;
import org.pendant.gui.shell.run.RunView;
import org.pendant.gui.workbench.View;

/** Everything that is in the window: a line for each view. */
final class Views {
  private final List<Place> places;
  private final ScriptEditor editor;
  private final ProgramRunner runner;
  private final DebugPresenter debug;

  /**
   * A view and where it belongs at first.
   *
   * @param glyph of its button in the rail; empty for one that is only a panel
   */
  private record Place(View view, Side home, Optional<Glyph> glyph) {}

  Views(ShellWorkbench workbench, Programs programs, ProgramRunner runner) {
    editor = new ScriptEditor(workbench, programs);
    this.runner = runner;
    workbench.showSourceIn(editor.id(), editor::show);
    debug = new DebugPresenter(workbench, programs);
    debug.breakpoints().setMarks(editor::toggleBreakpoint);
    editor.addBreakpointListener(debug.breakpoints()::linesChanged);
    runner.beforeEachRun(this::handOverBreakpoints);
    BreakpointsView breakpoints = new BreakpointsView(workbench, debug);
    DebugActions.addTo(workbench, debug, breakpoints, editor::caretLine);
    ScenePanel scene = new ScenePanel(workbench);
    View run = new RunView(workbench, workbench.actions(), programs, runner::line, runner::send);
    places =
        List.of(
            screen(run, Glyph.RUN),
            // A Program screen goes here.
            screen(editor, Glyph.SCRIPT),
            // An Installation screen goes here.
            screen(new MoveView(workbench, scene, editor::insertLine), Glyph.MOVE),
            screen(new IoView(workbench), Glyph.SIGNALS),
            screen(new LogView(workbench), Glyph.LOG),
            screen(new PlotView(workbench), Glyph.PLOT),
            panel(scene, Side.RIGHT),
            panel(new VariablesView(workbench, debug), Side.RIGHT),
            panel(new WatchesView(workbench, debug), Side.RIGHT),
            panel(new OutlineView(workbench, editor), Side.RIGHT),
            panel(new ProblemsView(workbench, editor), Side.BOTTOM),
            panel(new PlacesView(workbench, editor), Side.BOTTOM),
            panel(new CallStackView(workbench, debug), Side.BOTTOM),
            panel(breakpoints, Side.BOTTOM));
  }

  private void handOverBreakpoints(ProgramDocument document) {
    debug.breakpoints().linesChanged(document, editor.breakpoints(document));
    debug.breakpoints().beforeRun(document);
  }

  private static Place screen(View view, Glyph glyph) {
    return new Place(view, Side.MAIN, Optional.of(glyph));
  }

  private static Place panel(View view, Side home) {
    return new Place(view, home, Optional.empty());
  }

  /** Has debugger and editor follow the program, whatever is in front. */
  void follow(ControllerState state) {
    debug.refresh(state);
    int line = debug.held() ? debug.executionLine() : state.program().line();
    runner.program().ifPresent(program -> editor.setExecutionLine(program, line));
  }

  /** All of them, screens first. */
  List<View> all() {
    return places.stream().map(Place::view).toList();
  }

  /** Where each belongs at first, by id. */
  Map<String, Side> home() {
    Map<String, Side> home = new LinkedHashMap<>();
    places.forEach(place -> home.put(place.view().id(), place.home()));
    return home;
  }

  /** The glyph of each screen, by id, in the order of the rail. */
  Map<String, Glyph> screens() {
    Map<String, Glyph> screens = new LinkedHashMap<>();
    places.forEach(
        place -> place.glyph().ifPresent(glyph -> screens.put(place.view().id(), glyph)));
    return screens;
  }
}
