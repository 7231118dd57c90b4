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
import org.pendant.gui.debug.EditorLink;
import org.pendant.gui.debug.Favourites;
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
import org.pendant.gui.ports.DeskPorts;
import org.pendant.gui.ports.PortWishes;
import org.pendant.gui.ports.PortsView;
import org.pendant.gui.ports.StateFolder;
import org.pendant.gui.session.Programs;
import org.pendant.gui.session.Session;
import org.pendant.gui.shell.dock.Side;
import org.pendant.gui.shell.look.Glyph;
import org.pendant.gui.shell.run.RunView;
import org.pendant.gui.workbench.View;

/** Everything that is in the window: a line for each view. */
final class Views {
  private final List<Place> places;
  private final ScriptEditor editor;
  private final ProgramRunner runner;
  private final LogView log;
  private final DebugPresenter debug;
  private final EditorLink link;
  private final PortsView ports;
  private final Session session;
  private long strangers;

  /**
   * A view and where it belongs at first.
   *
   * @param glyph of its button in the rail; empty for one that is only a panel
   */
  private record Place(View view, Side home, Optional<Glyph> glyph) {}

  Views(ShellWorkbench workbench, Programs programs, ProgramRunner runner) {
    editor = new ScriptEditor(workbench, programs);
    this.runner = runner;
    session = workbench.session();
    ports =
        new PortsView(
            workbench, new DeskPorts(session, StateFolder.of(System.getenv()).resolve("desktop")));
    workbench.showSourceIn(editor, editor::show);
    debug = new DebugPresenter(workbench, programs);
    link = new EditorLink(editor, debug, programs);
    runner.beforeEachRun(link::beforeRun);
    BreakpointsView breakpoints = new BreakpointsView(workbench, debug);
    DebugActions.addTo(workbench, debug, breakpoints, editor::caretLine);
    ScenePanel scene = new ScenePanel(workbench);
    Favourites favourites = new Favourites(workbench.settings());
    PlotView plots = new PlotView(workbench);
    View run =
        new RunView(
            workbench,
            workbench.actions(),
            programs,
            runner::line,
            runner::send,
            line -> showStarted(workbench, programs, line),
            favourites);
    log = new LogView(workbench, line -> showStarted(workbench, programs, line));
    places =
        List.of(
            screen(run, Glyph.RUN),
            // A Program screen goes here.
            screen(editor, Glyph.SCRIPT),
            // An Installation screen goes here.
            screen(new MoveView(workbench, scene, editor::insertLine), Glyph.MOVE),
            screen(new IoView(workbench), Glyph.SIGNALS),
            screen(log, Glyph.LOG),
            screen(plots, Glyph.PLOT),
            panel(scene, Side.RIGHT),
            panel(new VariablesView(workbench, debug, favourites, plots::addVariables), Side.RIGHT),
            panel(new WatchesView(workbench, debug), Side.RIGHT),
            panel(new OutlineView(workbench, editor), Side.RIGHT),
            panel(ports, Side.RIGHT),
            panel(new ProblemsView(workbench, editor), Side.BOTTOM),
            panel(new PlacesView(workbench, editor), Side.BOTTOM),
            panel(new CallStackView(workbench, debug), Side.BOTTOM),
            panel(breakpoints, Side.BOTTOM));
  }

  /** Shows a line of the program that was started last, whichever is in front. */
  private void showStarted(ShellWorkbench workbench, Programs programs, int line) {
    if (runner.program().isEmpty() && session.strangerLast()) {
      workbench.notify("Line " + line + " is in a program that was sent from outside");
      return;
    }
    runner.program().ifPresent(programs::select);
    workbench.showSource(line, 1);
  }

  /** Lets others reach the controller. */
  void openPorts(PortWishes wishes) {
    ports.open(wishes);
  }

  /** Keeps what the window tells. */
  void told(String text) {
    log.told(text);
  }

  private static Place screen(View view, Glyph glyph) {
    return new Place(view, Side.MAIN, Optional.of(glyph));
  }

  private static Place panel(View view, Side home) {
    return new Place(view, home, Optional.empty());
  }

  /** Has debugger and editor follow the program, whatever is in front. */
  void follow(ControllerState state) {
    if (session.strangersStarted() != strangers) {
      strangers = session.strangersStarted();
      runner.forget();
      link.strangerStarted();
    }
    debug.refresh(state);
    link.follow(state);
  }

  /** All of them, screens first. */
  List<View> all() {
    return places.stream().map(Place::view).toList();
  }

  /** Whether people see the view of this id. */
  boolean showing(String id) {
    return places.stream()
        .map(Place::view)
        .anyMatch(view -> view.id().equals(id) && view.component().isShowing());
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
