package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.Timer;
import org.pendant.command.service.PortWishes;
import org.pendant.command.service.StartInstallation;
import org.pendant.command.service.StateFolder;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.cell.CellView;
import org.pendant.desktop.help.HelpActions;
import org.pendant.desktop.help.WelcomeCard;
import org.pendant.desktop.program.ProgramView;
import org.pendant.desktop.session.InstallationLink;
import org.pendant.desktop.session.OpenFiles;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.ProgramPhase;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RecoveryFolder;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SceneFile;
import org.pendant.desktop.session.SceneMemory;
import org.pendant.desktop.session.StillArm;
import org.pendant.desktop.shell.chrome.ArmBar;
import org.pendant.desktop.shell.chrome.Footer;
import org.pendant.desktop.shell.chrome.Header;
import org.pendant.desktop.shell.chrome.ProgramMenu;
import org.pendant.desktop.shell.chrome.Rail;
import org.pendant.desktop.shell.chrome.StatusLine;
import org.pendant.desktop.shell.prompt.PromptPanel;
import org.pendant.desktop.shell.start.StartPanel;
import org.pendant.desktop.sweep.SweepView;
import org.pendant.desktop.timeline.TimelineView;
import org.pendant.desktop.unit.FormMemory;
import org.pendant.desktop.waveform.WaveformView;
import org.pendant.desktop.workbench.View;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.dock.DockFrame;
import org.pendant.kit.dock.DockPlan;
import org.pendant.kit.fault.Faults;
import org.pendant.kit.settings.ConfigurationFolder;
import org.pendant.kit.settings.LanguageSetting;
import org.pendant.kit.settings.Settings;
import org.pendant.kit.theme.Look;
import org.pendant.project.installation.file.InstallationFile;

/** Desktop window: makes its parts, puts them together and shows them the newest snapshot. */
final class DesktopWindow {
  /** How often what is not saved is kept against a crash. */
  static final int KEEP_MS = 2_000;

  /** How many warnings are shown at a time; they take room from the views. */
  private static final int WARNINGS = 3;

  private final RobotSession session;
  private final Look look;
  private final Programs programs;
  private final ActionTable actions;
  private final ProgramRunner runner;
  private final ProgramFiles files;
  private final InstallationFiles installationFiles;
  private final SceneFiles scenes;
  private final ShellWorkbench workbench;
  private final Views views;
  private final DockFrame docks;
  private final Autosave autosave;
  private final DiskWatch disk;
  private final OtherWindows others;
  private final CloseDialog closeDialog;
  private final PromptPanel prompts;
  private final StartPanel startPanel;
  private final StopNotice stopNotice;
  private final WindowFrame window;
  private final Typing typing = new Typing();
  private final Notices notices = new Notices();
  private final StatusLine status = new StatusLine(text -> notices.tell(Notices.WHOLE, text));
  private final Header header;
  private final CellArms arms;
  private final ArmBar armBar;
  private final RobotChange robot;
  private final StillArm stillArm = new StillArm();
  private final Footer footer;
  private final Menus menus;
  private final WelcomeCard welcome;
  private final RefreshTimer refresh;
  private final HeapCare heap;
  private final Timer keep = Faults.timer(KEEP_MS, this::keep);
  private final Runnable closed;
  private boolean failureTold;
  private int warnings;

  /**
   * What is in the window, not visible yet.
   *
   * @param window the frame around it
   * @param closed runs when it has been closed
   */
  DesktopWindow(
      WindowFrame window,
      RobotSession session,
      Settings settings,
      Look look,
      Programs programs,
      RecoveryFolder recovery,
      OpenFiles openFiles,
      Runnable closed) {
    assert EventQueue.isDispatchThread();
    this.window = window;
    this.session = session;
    heap = HeapCare.with(session::storedBytes);
    this.look = look;
    this.programs = programs;
    this.closed = closed;
    actions = new ActionTable(settings);
    actions.setScreens(List.of("editor", "tree", "edit"));
    workbench = new ShellWorkbench(session, actions, settings, status::tell, typing);
    runner = new ProgramRunner(session, programs, this::tellOfProgram, workbench::showSource);
    ProgramActions programActions = new ProgramActions(actions, session, runner);
    programActions.addProgram();
    programActions.addRobot();
    views = new Views(workbench, programs, runner);
    workbench.openFilesAre(
        () -> EditedFiles.of(programs, views.installation(), views.sceneDraft()));
    workbench.programFolderIs(() -> programs.current().file().map(Path::getParent));
    status.alsoTell(views::told);
    // before whoever sets controllers up
    arms = new CellArms(session, programs, views.installation(), runner, this::showRobot);
    arms.showBy(this::showOfCell);
    CellActions.addTo(actions, session, arms, runner, status::tell);
    armBar = new ArmBar(actions, session::show, CellActions.TOGETHER);
    var _ =
        new InstallationLink(
            session,
            views.installation(),
            EventQueue::invokeLater,
            status::tell,
            runner::startByInput);
    docks =
        new DockFrame(
            new DockPlan(settings, views.places().home(), Views.WIDE),
            views.places().all(),
            views.places().home(),
            this::furnish);
    workbench.attach(docks);
    SaveQueue saves = new SaveQueue();
    DocumentSaver saver = new DocumentSaver(saves, notices, status::tell, this::warn);
    files =
        new ProgramFiles(
            programs,
            saver,
            settings,
            notices,
            status::tell,
            this::warn,
            workbench.usedFolder(),
            docks.component());
    files.showBy(opened -> views.showOpened(workbench, opened));
    files.openBy(this::open);
    installationFiles =
        new InstallationFiles(
            views.installation(),
            saver,
            settings,
            notices,
            status::tell,
            this::warn,
            workbench.usedFolder(),
            docks.component());
    header =
        new Header(
            new ProgramMenu(actions, programs, files::recent, files::open), this::chooseRobot);
    robot =
        new RobotChange(session, arms::expect, settings, notices, status::tell, header::showRobot);
    scenes =
        new SceneFiles(
            views.installation(),
            views.sceneDraft(),
            saver,
            new SceneMemory(settings),
            notices,
            status::tell,
            workbench.usedFolder(),
            docks.component(),
            robot::surround);
    scenes.showBy(() -> docks.show(CellView.ID));
    autosave =
        new Autosave(
            programs, views.installation(), views.sceneDraft(), recovery, notices, this::warn);
    disk = new DiskWatch(programs, views.installation(), saves, notices, status::tell);
    others = new OtherWindows(programs, views.installation(), openFiles, notices, status::tell);
    closeDialog =
        new CloseDialog(
            programs,
            files,
            views.installation(),
            installationFiles,
            views.sceneDraft(),
            scenes,
            saves,
            notices,
            this::dispose);
    window.askedToClose(closeDialog::ask);
    welcome = new WelcomeCard(actions, settings, docks.component());
    programs.addListener(welcome::close);
    docks.addListener(welcome::close);
    addActions(programActions);
    footer = new Footer(session, actions, runner::send);
    prompts = new PromptPanel(docks.component(), actions, runner::send);
    startPanel = new StartPanel(docks.component(), views.start());
    stopNotice =
        new StopNotice(
            notices,
            () -> FormMemory.read(settings),
            () -> views.places().showing("run"),
            () -> docks.show("run"));
    KeyBindings.bind(window.frame().getRootPane(), actions);
    menus = menus();
    refresh = new RefreshTimer(session, this::refresh, () -> docks.seen(WindowFrame::seen));
    build();
    follow();
    window.oncePainted(window::drawIcon);
    window.oncePainted(views::openBehind);
  }

  private Menus menus() {
    return new Menus(
        actions,
        menuPlan(),
        Map.of(
            text("recentPrograms"),
            () -> Menus.items(files.recent(), files::open),
            text("recentInstallations"),
            () -> Menus.items(installationFiles.recent(), installationFiles::open)));
  }

  private List<MenuPlan.Menu> menuPlan() {
    Set<String> screens = views.places().screens().keySet();
    return MenuPlan.of(
        List.copyOf(screens),
        views.places().all().stream().map(View::id).filter(id -> !screens.contains(id)).toList());
  }

  private Map<String, List<String>> actionsByMenu() {
    return MenuPlan.byTitle(menuPlan(), actions.all().stream().map(Action::id).toList());
  }

  private void addActions(ProgramActions programActions) {
    programActions.addFiles(files, programs);
    new UrpExport(
            programs,
            () -> views.installation().current(),
            notices,
            docks.component(),
            status::tell)
        .addAction(actions);
    installationFiles.addActions(actions);
    scenes.addActions(actions);
    actions.add(
        Action.of("file.recent", text("openARecentProgram"), "control E", header::openPrograms));
    actions.add(Action.of("file.quit", text("quit"), "control Q", closeDialog::ask));
    actions.add(
        Action.of("robot.restart", text("switchTheControllerOffAndOn"), "", robot::restart));
    actions.add(
        Action.of("robot.noise", text("noiseOfSensors"), "", robot::switchNoise)
            .checked(() -> session.options().noise().measured()));
    actions.add(
        Action.of("robot.start-ramp", text("startRampOfPrograms"), "", robot::switchStartRamp)
            .checked(() -> session.options().startRamp()));
    actions.add(Action.of("robot.choose", text("chooseAnotherRobot"), "", header::openRobots));
    programActions.addSpeed();
    UnitActions.addTo(actions, workbench.settings());
    // The permanent owner: an open menu has the keyboard for a while.
    ClipboardActions.addTo(
        actions, KeyboardFocusManager.getCurrentKeyboardFocusManager()::getPermanentFocusOwner);
    WindowActions windowActions = new WindowActions(actions);
    windowActions.addViews(docks, List.copyOf(views.places().screens().keySet()));
    windowActions.addDocks(docks);
    windowActions.addLook(look);
    LanguageActions.addTo(actions, new LanguageSetting(workbench.settings()), status::tell);
    windowActions.addHelp(docks.component(), notices, status::text);
    ExampleFiles examples =
        new ExampleFiles(
            files, installationFiles, scenes, notices, docks.component(), status::tell);
    HelpActions help =
        new HelpActions(
            actions,
            docks.component(),
            this::actionsByMenu,
            StateFolder.of(System.getenv()),
            ConfigurationFolder.of(System.getProperties(), System.getenv()),
            status::tell);
    help.add(views::explain, examples::open, () -> docks.mainView().orElse(""));
    programs.addListener(help::close);
    docks.addShowListener(help::close);
    welcome.addAction();
  }

  private void build() {
    JPanel middle = new JPanel(new BorderLayout());
    JPanel above = new JPanel(new BorderLayout());
    above.add(notices, BorderLayout.NORTH);
    above.add(armBar, BorderLayout.CENTER);
    middle.add(above, BorderLayout.NORTH);
    middle.add(docks.component(), BorderLayout.CENTER);
    JPanel south = new JPanel(new BorderLayout());
    south.add(new StatusRow(views.past().banner(), status), BorderLayout.NORTH);
    south.add(footer, BorderLayout.CENTER);
    window.removeOutline();
    JFrame frame = window.frame();
    frame.getRootPane().setTransferHandler(new FileDrop(this::open, this::warn));
    frame.add(header, BorderLayout.NORTH);
    frame.add(rail(), BorderLayout.WEST);
    frame.add(middle, BorderLayout.CENTER);
    frame.add(south, BorderLayout.SOUTH);
    frame.setJMenuBar(menus.bar());
  }

  private Rail rail() {
    Rail rail = new Rail(actions, docks::show, docks::moveMenu);
    for (View view : views.places().all()) {
      if (views.places().screens().containsKey(view.id())) {
        rail.add(view, views.places().screens().get(view.id()));
      }
    }
    Runnable mark = () -> rail.mark(docks.mainView().orElse(""));
    docks.addListener(mark);
    mark.run();
    return rail;
  }

  private void follow() {
    ProgramDocument.Listener changed =
        new ProgramDocument.Listener() {
          @Override
          public void fileChanged() {
            showProgram();
          }
        };
    programs.addListener(
        () -> {
          programs.current().removeListener(changed);
          programs.current().addListener(changed);
          showProgram();
        });
    programs.current().addListener(changed);
  }

  private void showProgram() {
    header.show(programs.current());
    menus.showFor(programs.current().isTree());
    String mark = programs.current().modified() ? "\u2022 " : "";
    window.frame().setTitle(mark + programs.current().name() + " - Pendant");
  }

  /** The window's frame. */
  JFrame frame() {
    return window.frame();
  }

  /** Brings a screen or a panel to the front. */
  void show(String id) {
    docks.show(id);
  }

  /** The screens and panels, by id. */
  List<String> views() {
    return views.places().all().stream().map(View::id).toList();
  }

  /** Does what an action does, if it can be done now. */
  void perform(String actionId) {
    actions.run(actionId);
  }

  /** Shows the newest snapshot in all views, also those that nobody sees. */
  void refreshAll() {
    refresh(each -> true);
  }

  /** Shows the window. */
  void open() {
    fill();
    typing.start();
    window.frame().setVisible(true);
    window.frame().validate();
    docks.mainView().ifPresent(docks::show);
    docks.raiseWindows();
    refresh.start();
    keep.start();
    lookAround();
  }

  /** Shows the program and the robot that there are at first. */
  void fill() {
    showProgram();
    header.showRobot(session.options().robotId());
    refresh();
  }

  /** Looks what an earlier window has left and what others have open, and tells. */
  void lookAround() {
    views.keeper().notice().ifPresent(this::warn);
    autosave.offerLeftBehind();
    programs.addListener(others::look);
    others.look();
    installationFiles.offerBeside(programs);
  }

  /**
   * Says at the very first start where to begin.
   *
   * @param alone whether the user has opened nothing
   */
  void welcome(boolean alone) {
    if (alone) {
      welcome.openAtFirst();
    }
  }

  /**
   * Opens a program, an installation, a scene, a recording, a plan or a table of waveforms. Dialogs
   * begin in its folder afterwards.
   */
  void open(Path file) {
    workbench.usedFolder().chosen(file);
    if (InstallationFile.hasEnding(file.toString())) {
      installationFiles.open(file);
      return;
    }
    if (SceneFile.hasEnding(file)) {
      scenes.open(file);
      return;
    }
    if (TimelineView.isRecording(file)) {
      views.past().open(file);
      return;
    }
    if (WaveformView.isWaveforms(file)) {
      views.waveforms().open(file);
      return;
    }
    if (SweepView.isPlan(file)) {
      views.sweep().open(file);
      return;
    }
    files.open(file);
  }

  /** Takes the installation that the controller has begun with. */
  void begin(StartInstallation start) {
    if (session.inCell()) {
      scenes.belongTo(start.file());
      arms.whenAlone(() -> installationFiles.begin(start));
    } else {
      installationFiles.begin(start);
    }
  }

  /** Takes what the controllers of a cell have begun with. */
  void begin(CellStart start) {
    arms.begin(start);
    start.troubles().forEach(this::warn);
  }

  /** A script says nothing on the screen of nodes. */
  private void showOfCell(ProgramDocument program) {
    if (views.places().showing(ProgramView.ID)) {
      views.showOpened(workbench, program);
    }
  }

  /** Takes the scene that the controller has begun with. */
  void begin(StartScene start) {
    scenes.begin(start);
  }

  /** Lets others reach the controller. */
  void openPorts(PortWishes wishes) {
    views.openPorts(wishes);
    docks.show("ports");
  }

  /** What is told of a program is over when that is started, paused, resumed or has ended. */
  private void tellOfProgram(String text) {
    welcome.close();
    ProgramPhase phase = ProgramPhase.of(session.state());
    status.tell(text, () -> ProgramPhase.of(session.state()) == phase);
  }

  /** Tells something at the edge of the window. */
  void tell(String text) {
    status.tell(text);
  }

  /** Tells something that must not be overlooked; a few of these are enough at a time. */
  void warn(String text) {
    views.told(text);
    warnings++;
    notices.tell("warning-" + warnings, text);
    notices.close("warning-" + (warnings - WARNINGS));
  }

  private void refresh() {
    refresh(WindowFrame::seen);
  }

  private void refresh(Predicate<Component> seen) {
    ControllerState state = stillArm.shown(session.state());
    if (seen.test(docks.component())) {
      Faults.guard(() -> header.refresh(state));
      Faults.guard(
          () -> armBar.refresh(session.inCell() ? session.members() : List.of(), session.shown()));
      Faults.guard(() -> footer.refresh(state));
    }
    Faults.guard(
        () -> status.refresh(session.lateness(), session.pace(), state.behindS(), session.held()));
    Faults.guard(arms::refresh);
    Faults.guard(() -> prompts.refresh(state));
    Faults.guard(() -> stopNotice.refresh(state));
    Faults.guard(() -> views.follow(state));
    Faults.guard(() -> startPanel.refresh(state));
    for (View view : views.places().all()) {
      if (seen.test(view.component())) {
        Faults.guard(() -> view.refresh(views.past().shown(view, state)));
      }
    }
    Optional<Throwable> failure = session.failure();
    if (failure.isPresent() && !failureTold) {
      status.tell(text("theControllerHasFailedAnInternal", failure.get()));
    }
    failureTold = failure.isPresent();
  }

  /** What is done every few seconds: one part continues when another has failed. */
  private void keep() {
    Faults.guard(autosave::look);
    Faults.guard(disk::look);
    Faults.guard(scenes::look);
    Faults.guard(others::look);
    Faults.guard(views.keeper()::look);
    Faults.guard(() -> session.newTrouble().ifPresent(this::warn));
    Faults.guard(() -> heap.look(HeapCare.Doing.of(session.robot(), typing.going())));
  }

  private void showRobot(String id) {
    header.showRobot(id);
  }

  private void chooseRobot(String id) {
    robot.choose(id);
  }

  /** What the window of a panel has in common with this one. */
  private void furnish(JFrame panelWindow) {
    panelWindow.setIconImages(WindowFrame.icons());
    KeyBindings.bind(panelWindow.getRootPane(), actions);
  }

  /** Closes it without asking. */
  void dispose() {
    refresh.stop();
    keep.stop();
    typing.stop();
    // Whatever these throw, the window closes.
    Faults.guard(autosave::end);
    Faults.guard(others::end);
    Faults.guard(views.keeper()::look);
    docks.close();
    window.end();
    closed.run();
  }
}
