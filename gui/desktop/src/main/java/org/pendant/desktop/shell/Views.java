package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;
import static org.pendant.desktop.shell.ViewPlaces.panel;
import static org.pendant.desktop.shell.ViewPlaces.screen;

import java.awt.EventQueue;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.pendant.command.service.PortWishes;
import org.pendant.command.service.StateFolder;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.cell.CellView;
import org.pendant.desktop.debug.BreakpointsView;
import org.pendant.desktop.debug.CallStackView;
import org.pendant.desktop.debug.DebugActions;
import org.pendant.desktop.debug.DebugBar;
import org.pendant.desktop.debug.DebugPresenter;
import org.pendant.desktop.debug.EditorLink;
import org.pendant.desktop.debug.Favourites;
import org.pendant.desktop.debug.FileKeeper;
import org.pendant.desktop.debug.HiddenNames;
import org.pendant.desktop.debug.HoverValues;
import org.pendant.desktop.debug.StartedProgram;
import org.pendant.desktop.debug.VariablesView;
import org.pendant.desktop.debug.WatchesView;
import org.pendant.desktop.editor.OutlineView;
import org.pendant.desktop.editor.PlacesView;
import org.pendant.desktop.editor.ProblemsView;
import org.pendant.desktop.editor.ScriptEditor;
import org.pendant.desktop.help.OtherProgram;
import org.pendant.desktop.installation.InstallationView;
import org.pendant.desktop.io.IoView;
import org.pendant.desktop.io.SignalLabels;
import org.pendant.desktop.lines.MotionView;
import org.pendant.desktop.lines.PathStrip;
import org.pendant.desktop.log.LogView;
import org.pendant.desktop.move.MoveView;
import org.pendant.desktop.plot.PlotView;
import org.pendant.desktop.ports.ClientsView;
import org.pendant.desktop.ports.DesktopPorts;
import org.pendant.desktop.ports.PortsView;
import org.pendant.desktop.program.ProgramView;
import org.pendant.desktop.program.ScriptLink;
import org.pendant.desktop.program.TreePrograms;
import org.pendant.desktop.program.TreeRuns;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.desktop.session.StateWords;
import org.pendant.desktop.shell.run.RunView;
import org.pendant.desktop.shell.start.StartChoice;
import org.pendant.desktop.sweep.SweepView;
import org.pendant.desktop.tests.TestsView;
import org.pendant.desktop.waveform.WaveformView;
import org.pendant.desktop.whatif.WhatIfView;
import org.pendant.desktop.workbench.View;
import org.pendant.kit.background.WorkerThread;
import org.pendant.kit.dock.Side;
import org.pendant.kit.fault.Faults;
import org.pendant.kit.icon.Glyph;

/** Views: everything that is in the window: a line for each view. */
final class Views {
  /** The screens on which people look at the arm as much as at the screen. */
  static final Set<String> WIDE = Set.of("run", "move");

  private final ViewPlaces places;
  private final ScriptEditor editor;
  private final ProgramView program;
  private final ActiveInstallation installation = new ActiveInstallation();
  private final SceneDraft sceneDraft = new SceneDraft();
  private final ProgramRunner runner;
  private final LogView log;
  private final DebugPresenter debug;
  private final EditorLink link;
  private final PathStrip strip;
  private final FileKeeper keeper;
  private final List<DebugBar> debugBars;
  private final BusyNotice busy;
  private final LineNames names;
  private final RunPlaces runPlaces;
  private final HiddenNames hidden;
  private final PortsView ports;
  private final RobotSession session;
  private final Consumer<String> tell;
  private final StartMove startMove;
  private final WaveformView waveforms;
  private final TestsView tests;
  private final SweepView sweep;
  private final StartChoice start;
  private final PastViews past;
  private TreeRuns runs;
  private final ReceivedProgram received;
  private long strangers;

  /** The controller whose programs are followed. */
  private String followed = "";

  Views(ShellWorkbench workbench, Programs programs, ProgramRunner runner) {
    editor = new ScriptEditor(workbench, programs);
    this.runner = runner;
    session = workbench.session();
    tell = workbench::notify;
    DesktopPorts desktopPorts =
        new DesktopPorts(
            session, StateFolder.of(System.getenv()).resolve("desktop"), this::visited);
    ports = new PortsView(workbench, desktopPorts);
    received = new ReceivedProgram(programs);
    hidden = new HiddenNames(workbench.settings());
    debug = new DebugPresenter(workbench, programs);
    keeper = new FileKeeper(workbench.settings(), programs, editor, debug.breakpoints());
    link = new EditorLink(editor, debug, programs);
    strip =
        new PathStrip(workbench.settings(), session::profile, () -> System.nanoTime() / 1_000_000);
    strip.showIn(editor::showNotes);
    strip.addTo(workbench.actions());
    strip.whenBack(this::backTo);
    runner.stepOverBy(debug.steps()::over);
    BreakpointsView breakpoints = new BreakpointsView(workbench, debug);
    editor.setMarginMenu(breakpoints.marginMenu());
    DebugActions.addTo(workbench, debug, breakpoints, editor::caretLine);
    past = new PastViews(workbench, programs, editor, debug.breakpoints()::stopping);
    debug.steps().inThePast(past.steps()::back, past.steps()::stepOn);
    DebugBar scriptBar = new DebugBar("debug-bar", workbench, debug, past.steps());
    scriptBar.keepRoom();
    editor.addToHead(scriptBar);
    DebugBar treeBar = new DebugBar("debug-bar-tree", workbench, debug, past.steps());
    debugBars = List.of(scriptBar, treeBar);
    ScenePanel scene = new ScenePanel(workbench, past::past, past::opened);
    MoveView move =
        new MoveView(workbench, scene, line -> insertLine(programs.current().isTree(), line));
    runner.beforeEachRun(
        (document, script) -> {
          move.discardGoal();
          hidden.start(script.names());
          link.beforeRun(document, script);
          strip.beforeRun(document, script);
          logStart(started -> started.start(document, script));
        });
    program = programScreen(workbench, programs, move, scene);
    names = new LineNames(runs, runner, debug);
    runPlaces =
        new RunPlaces(
            runs,
            program::show,
            (document, line) -> {
              programs.select(document);
              workbench.showSource(line, 1);
            });
    past.setRunPlaces(runPlaces);
    debug.nameLinesBy(names::started);
    past.timeline().setPins(strip::profile, new ProfilePins(strip, names, past::programAt)::of);
    past.timeline()
        .nameLinesBy(
            (timeS, line) ->
                past.ofLastRun(timeS)
                    ? names.started(line)
                    : names.of(past.programAt(timeS), line));
    runner.nameLinesBy((document, line) -> names.of(Optional.of(document), line));
    scene.onNode(program::choose);
    scene.onMoment(past::explain);
    scene.onLine(line -> showTraced(workbench, programs, line));
    scene.setPlaces(line -> StateWords.capital(traced(line)));
    past.setPlaces(line -> names.of(past.program(), line));
    program.addBelow(treeBar);
    busy =
        new BusyNotice(workbench, debug, line -> runs.node(runner.program(), debug.lineNow(line)));
    editor.setValues(
        new HoverValues(debug, () -> past.past().orElseGet(session::state).variables())::of);
    installation.addListener(
        () -> {
          scene.show(installation.current().features());
          move.setInstallation(installation.current());
        });
    move.whenHomeSet(home -> installation.set(installation.current().withHome(home)));
    startMove = new StartMove(session, this::forgetRun);
    start = new StartChoice(startMove, workbench.settings());
    runner.whenForgotten(this::forgetRun);
    runner.setTexts(runs::plan);
    RunFrom.addTo(workbench.actions(), session, runs, program::selected, runner, start, tell);
    workbench.showSourceIn(
        () -> programs.current().isTree() && !editor.component().isShowing() ? program : editor,
        (line, column) -> showSource(programs.current().isTree(), line, column));
    Favourites favourites = new Favourites(workbench.settings());
    SignalLabels labels = InstalledLabels.of(workbench, installation);
    PlotView plots = new PlotView(workbench, labels, hidden);
    View run =
        new RunView(
            workbench,
            workbench.actions(),
            past.run(
                new StartedRun(
                    session,
                    programs,
                    runner,
                    debug,
                    runs,
                    installation,
                    line -> showStarted(workbench, programs, line),
                    program::show),
                line -> runs.node(past.program(), line)),
            runner::send,
            favourites,
            hidden,
            past::showBefore);
    VariablesView variables =
        new VariablesView(workbench, debug, favourites, hidden, plots::addVariables);
    variables.setPast(past::past);
    variables.whenSelected(past.steps()::watch);
    View watches = new LateView(WatchesView.ID, WatchesView.TITLE, () -> watches(workbench));
    View calls = new LateView(CallStackView.ID, CallStackView.TITLE, () -> callStack(workbench));
    InstallationView installed = new InstallationView(workbench, installation);
    scene.setProposedSafety(installed::proposedSafety);
    CellView cell = new CellView(workbench, sceneDraft, labels::ofSignal);
    scene.setObjectHand(cell.hand(() -> places().showing(CellView.ID) && past.past().isEmpty()));
    scene.setProposedScene(
        () -> places().showing(CellView.ID) ? Optional.of(sceneDraft.scene()) : Optional.empty());
    scene.setChosenDevice(
        () -> places().showing(CellView.ID) ? cell.chosenDevice() : Optional.empty());
    scene.setProposedDevices(
        () -> places().showing(CellView.ID) ? Optional.of(sceneDraft.devices()) : Optional.empty());
    log = new LogView(workbench, line -> showStarted(workbench, programs, line));
    tests = new TestsView(workbench, programs, editor, installation, runner::startsElsewhere);
    runner.setGate(new RunGate(session, program, runs, installation, tests, start, tell));
    waveforms = new WaveformView(workbench, labels::ofSignal, () -> chooseWaveforms(workbench));
    sweep =
        new SweepView(
            workbench,
            programs,
            installation,
            sceneDraft,
            past::open,
            () -> choosePlan(workbench),
            page -> OtherProgram.openPage(page, tell));
    RunAsTest.addTo(workbench, programs, past, tests, labels::ofSignal);
    ClientsView clients = new ClientsView(workbench, desktopPorts, past::show);
    past.timeline().markClients(clients::marks, clients::showMessage);
    WhatIfView whatIf =
        new WhatIfView(
            workbench,
            past::past,
            past::ofFile,
            new EditedProgram(session, programs, runner, runs, names));
    scene.setCompared(whatIf::ways);
    places =
        ViewPlaces.of(
            screen(past.held(run), Glyph.RUN),
            screen(program, Glyph.PROGRAM),
            screen(editor, Glyph.SCRIPT),
            screen(installed, Glyph.INSTALLATION),
            screen(past.held(move), Glyph.MOVE),
            screen(past.held(new IoView(workbench, labels)), Glyph.SIGNALS),
            screen(log, Glyph.LOG),
            screen(plots, Glyph.PLOT),
            screen(past.held(cell), Glyph.CELL),
            panel(scene, Side.RIGHT),
            panel(past.selectable(variables), Side.LOWER),
            panel(past.selectable(watches), Side.LOWER),
            panel(
                new LateView(
                    OutlineView.ID, OutlineView.TITLE, () -> new OutlineView(workbench, editor)),
                Side.LOWER),
            panel(ports, Side.LOWER),
            panel(clients, Side.MAIN),
            panel(sweep, Side.MAIN),
            panel(
                new LateView(
                    ProblemsView.ID, ProblemsView.TITLE, () -> new ProblemsView(workbench, editor)),
                Side.BOTTOM),
            panel(new PlacesView(workbench, editor), Side.BOTTOM),
            panel(past.held(calls), Side.LOWER),
            panel(breakpoints, Side.BOTTOM),
            panel(past.timeline(), Side.BOTTOM),
            panel(tests, Side.BOTTOM),
            panel(waveforms, Side.BOTTOM),
            panel(whatIf, Side.BOTTOM),
            panel(
                new LateView(
                    MotionView.ID,
                    MotionView.TITLE,
                    () ->
                        new MotionView(
                            workbench,
                            past::explanation,
                            line -> names.of(past.program(), line),
                            () -> about(programs.current(), lineLookedAt()))),
                Side.BOTTOM));
  }

  private View watches(ShellWorkbench workbench) {
    WatchesView watches = new WatchesView(workbench, debug);
    watches.setPast(past::past);
    watches.whenSelected(past.steps()::watch);
    return watches;
  }

  private View callStack(ShellWorkbench workbench) {
    CallStackView calls = new CallStackView(workbench, debug);
    calls.setPast(past::past, line -> names.of(past.program(), line));
    return calls;
  }

  /** The line at the moment that people look at, or that of the caret. */
  private int lineLookedAt() {
    return past.past()
        .map(state -> state.program().line())
        .filter(line -> line > 0)
        .orElseGet(editor::caretLine);
  }

  private Optional<String> about(ProgramDocument document, int line) {
    return strip.about(document, line, names.of(Optional.of(document), line));
  }

  private ProgramView programScreen(
      ShellWorkbench workbench, Programs programs, MoveView move, ScenePanel scene) {
    WorkerThread worker = new WorkerThread("program-trees");
    TreePrograms trees =
        new TreePrograms(
            programs, installation, work -> worker.run(0, work), EventQueue::invokeLater);
    ScriptLink scripts = new ScriptLink(editor, debug, workbench::notify);
    scripts.setPast(past::line);
    scripts.setNotes(strip::nodes);
    trees.setSink(scripts);
    runs = new TreeRuns(trees, scripts);
    return new ProgramView(workbench, programs, trees, scripts, move::teach, scene::show);
  }

  /** What starts next is none of the open programs. */
  private void forgetRun() {
    runner.forget();
    link.strangerStarted(Optional.empty());
    strip.strangerStarted(Optional.empty());
  }

  private void logStart(Consumer<StartedProgram> start) {
    StartedProgram started = new StartedProgram();
    start.accept(started);
    log.startsRun(runPlaces.of(started));
  }

  /** After a branch an earlier run goes on, maybe that of another program than the last. */
  private void backTo(Optional<PathStrip.Ran> ran) {
    if (ran.isPresent() && !ran.get().received()) {
      runner.backTo(ran.get().document(), ran.get().script());
    } else {
      runner.forget();
      Optional<ProgramDocument> shown = ran.map(PathStrip.Ran::document);
      link.strangerStarted(shown);
      logStart(started -> started.startStranger(shown));
    }
  }

  /** What is asked before a program starts. */
  StartChoice start() {
    return start;
  }

  /** Writes a line of script: below the caret, or as a node of the tree. */
  private void insertLine(boolean tree, String line) {
    if (tree) {
      program.insertScript(line);
    } else {
      editor.insertLine(line);
    }
  }

  /**
   * Shows the program in front where it is written, and lets keys go there; the caret of an empty
   * script stands in its body.
   */
  void showOpened(ShellWorkbench workbench, ProgramDocument opened) {
    if (opened.isTree()) {
      workbench.show(ProgramView.ID);
      program.focus();
      return;
    }
    workbench.show(ScriptEditor.ID);
    if (opened.file().isEmpty() && !opened.modified()) {
      editor.showEmptyBody();
    }
    editor.focus();
  }

  private void showSource(boolean tree, int line, int column) {
    editor.show(line, column);
    if (tree) {
      program.showLine(line);
    }
  }

  /** Makes what is behind the program in front, which a start need not wait for. */
  void openBehind() {
    editor.openBehind();
  }

  /** Shows what is known about the name at the caret, or does {@code otherwise}. */
  void explain(Runnable otherwise) {
    if (editor.component().isShowing()) {
      editor.explain(otherwise);
    } else {
      otherwise.run();
    }
  }

  /** What programs can refer to. */
  ActiveInstallation installation() {
    return installation;
  }

  /** What is to be around the arm. */
  SceneDraft sceneDraft() {
    return sceneDraft;
  }

  /** Shows a line of the program that was started last, whichever is in front. */
  private void showStarted(ShellWorkbench workbench, Programs programs, int line) {
    Optional<ProgramDocument> started = runner.program().or(received::shown);
    if (started.isEmpty() && session.strangerLast()) {
      workbench.notify(text("lineIsInAProgramThat", line));
      return;
    }
    started.ifPresent(programs::select);
    workbench.showSource(debug.lineNow(line), 1);
  }

  /** What a line at which the tool was somewhere is called. */
  private String traced(int line) {
    return past.ofLastRun() ? names.started(line) : names.of(past.program(), line);
  }

  /** Leads to the line at which the tool was somewhere, unless that would take the screen away. */
  private void showTraced(ShellWorkbench workbench, Programs programs, int line) {
    if (!past.ofLastRun()) {
      // the editor shows the line of the moment that the click leads to, if that program is open
      return;
    }
    if (editor.component().isShowing() || program.component().isShowing()) {
      showStarted(workbench, programs, line);
    } else {
      tell.accept(text("theToolWasThereAtOf", traced(line)));
    }
  }

  /** Lets others reach the controller. */
  void openPorts(PortWishes wishes) {
    ports.open(wishes);
  }

  private void visited(String text) {
    log.visited(text);
  }

  /** Keeps what the window tells. */
  void told(String text) {
    log.told(text);
  }

  /** Has debugger and editor follow the program, whatever is in front. */
  void follow(ControllerState state) {
    boolean sameController = session.shown().name().equals(followed);
    followed = session.shown().name();
    if (!sameController) {
      strangers = session.strangersStarted();
    } else if (session.strangersStarted() != strangers) {
      strangers = session.strangersStarted();
      runner.forget();
      Optional<ProgramDocument> shown = received.show(session.startedSource());
      link.strangerStarted(shown);
      strip.strangerStarted(shown);
      logStart(started -> started.startStranger(shown));
    }
    Faults.guard(() -> debug.refresh(state));
    debugBars.forEach(each -> Faults.guard(each::refresh));
    Faults.guard(busy::refresh);
    Faults.guard(
        () -> {
          if (!past.follow(state, log)) {
            link.follow(state);
          }
        });
    Faults.guard(() -> startMove.refresh(state));
    Faults.guard(strip::refresh);
    Faults.guard(tests::follow);
  }

  /** Has what people see of each file last until they open it again. */
  FileKeeper keeper() {
    return keeper;
  }

  private void chooseWaveforms(ShellWorkbench workbench) {
    OpenDialog.show(
        waveforms.component(),
        text("openWaveforms"),
        text("tablesOfWaveforms"),
        new String[] {"csv"},
        workbench.usedFolder(),
        waveforms::open);
  }

  private void choosePlan(ShellWorkbench workbench) {
    OpenDialog.show(
        sweep.component(),
        text("openPlan"),
        text("plansOfSweeps"),
        new String[] {"toml"},
        workbench.usedFolder(),
        sweep::open);
  }

  /** The panel in which people run variants of a program by the thousand. */
  SweepView sweep() {
    return sweep;
  }

  /** The panel in which people draw what happens at the inputs. */
  WaveformView waveforms() {
    return waveforms;
  }

  /** What happens while people look at the past. */
  PastViews past() {
    return past;
  }

  /** All of them, and where each belongs. */
  ViewPlaces places() {
    return places;
  }
}
