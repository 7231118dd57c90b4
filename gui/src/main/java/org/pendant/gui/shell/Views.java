package org.pendant.gui.shell;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.debug.DebugState;
import org.pendant.controller.state.ControllerState;
import org.pendant.gui.editor.OutlineView;
import org.pendant.gui.editor.PlacesView;
import org.pendant.gui.editor.ProblemsView;
import org.pendant.gui.editor.ScriptEditor;
import org.pendant.gui.io.IoView;
import org.pendant.gui.log.LogView;
import org.pendant.gui.move.MoveView;
import org.pendant.gui.plot.PlotView;
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
  private long stopShown;

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
    View run = new RunView(workbench, workbench.actions(), programs, runner::line, runner::send);
    places =
        List.of(
            screen(run, Glyph.RUN),
            // A Program screen goes here.
            screen(editor, Glyph.SCRIPT),
            // An Installation screen goes here.
            screen(new MoveView(workbench), Glyph.MOVE),
            screen(new IoView(workbench), Glyph.SIGNALS),
            screen(new LogView(workbench), Glyph.LOG),
            screen(new PlotView(workbench), Glyph.PLOT),
            panel(planned("scene", "3D", "The arm and what is around it."), Side.RIGHT),
            panel(planned("variables", "Variables", "Values while a program runs."), Side.RIGHT),
            panel(new OutlineView(workbench, editor), Side.RIGHT),
            panel(new ProblemsView(workbench, editor), Side.BOTTOM),
            panel(new PlacesView(workbench, editor), Side.BOTTOM),
            panel(planned("call-stack", "Call stack", "Threads and calls."), Side.BOTTOM),
            panel(planned("breakpoints", "Breakpoints", "Where programs pause."), Side.BOTTOM));
  }

  private static View planned(String id, String title, String coming) {
    return new PlannedView(id, title, coming);
  }

  private static Place screen(View view, Glyph glyph) {
    return new Place(view, Side.MAIN, Optional.of(glyph));
  }

  private static Place panel(View view, Side home) {
    return new Place(view, home, Optional.empty());
  }

  /** Has the editor mark the line that the program has reached, and show where it is held. */
  void follow(ControllerState state, SourcePlace showSource) {
    Optional<DebugState.Stop> stop = state.debug().stop();
    int line = stop.map(DebugState.Stop::line).orElse(state.program().line());
    runner.program().ifPresent(program -> editor.setExecutionLine(program, line));
    if (stop.isPresent() && stop.get().number() != stopShown) {
      stopShown = stop.get().number();
      showSource.show(line, 1);
    }
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
