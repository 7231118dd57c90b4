package org.pendant.gui.shell;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Frame;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import org.pendant.controller.state.ControllerState;
import org.pendant.gui.session.ProgramControls;
import org.pendant.gui.session.ProgramDocument;
import org.pendant.gui.session.Programs;
import org.pendant.gui.session.RecoveryFolder;
import org.pendant.gui.session.Session;
import org.pendant.gui.shell.Notices.Choice;
import org.pendant.gui.shell.bar.Footer;
import org.pendant.gui.shell.bar.Header;
import org.pendant.gui.shell.bar.Rail;
import org.pendant.gui.shell.bar.StatusLine;
import org.pendant.gui.shell.dock.DockFrame;
import org.pendant.gui.shell.dock.DockPlan;
import org.pendant.gui.shell.find.CommandPalette;
import org.pendant.gui.shell.find.KeyEditor;
import org.pendant.gui.shell.look.Look;
import org.pendant.gui.shell.run.PopupPanel;
import org.pendant.gui.workbench.Action;
import org.pendant.gui.workbench.ActionTable;
import org.pendant.gui.workbench.KeyText;
import org.pendant.gui.workbench.Settings;
import org.pendant.gui.workbench.View;

/** The window: makes its parts, puts them together and shows them the newest snapshot. */
final class DesktopWindow {
  private static final int REFRESH_MS = 33;
  private static final int KEEP_MS = 2_000;
  private static final String ROBOT = "robot.id";

  private final Session session;
  private final Settings settings;
  private final Look look;
  private final Programs programs;
  private final ActionTable actions;
  private final ProgramRunner runner;
  private final ProgramFiles files;
  private final ShellWorkbench workbench;
  private final Views views;
  private final DockFrame docks;
  private final Keeper keeper;
  private final KeyBindings keys;
  private final PopupPanel popups;
  private final JFrame frame = new JFrame("Pendant");
  private final StatusLine status = new StatusLine();
  private final Notices notices = new Notices();
  private final Header header = new Header(this::chooseRobot);
  private final Footer footer;
  private final Timer refresh = new Timer(REFRESH_MS, event -> refresh());
  private final Timer keep;
  private final Runnable closed;
  private boolean failureTold;

  /**
   * The window, not visible yet.
   *
   * @param closed runs when it has been closed
   */
  DesktopWindow(
      Session session,
      Settings settings,
      Look look,
      Programs programs,
      RecoveryFolder recovery,
      Runnable closed) {
    assert EventQueue.isDispatchThread();
    this.session = session;
    this.settings = settings;
    this.look = look;
    this.programs = programs;
    this.closed = closed;
    actions = new ActionTable(settings);
    workbench = new ShellWorkbench(session, actions, settings, status::tell);
    runner = new ProgramRunner(session, programs, status::tell, workbench::showSource);
    ProgramActions programActions = new ProgramActions(actions, session, runner);
    programActions.addProgram();
    programActions.addRobot();
    views = new Views(workbench, programs, runner);
    docks = new DockFrame(new DockPlan(settings, views.home()), views.all(), views.home());
    workbench.attach(docks);
    files = new ProgramFiles(programs, settings, status::tell, docks.component());
    keeper = new Keeper(programs, recovery, notices, status::tell);
    keep = new Timer(KEEP_MS, event -> keeper.look());
    addActions(programActions);
    footer = new Footer(session, actions, runner::send);
    popups = new PopupPanel(docks.component(), runner::send);
    keys = new KeyBindings(frame.getRootPane(), actions);
    build();
    follow();
  }

  private void addActions(ProgramActions programActions) {
    programActions.addFiles(files, programs);
    actions.add(Action.of("file.quit", "Quit", "control Q", this::close));
    actions.add(
        new Action(
            "robot.restart",
            "Switch the controller off and on",
            "",
            () -> true,
            () -> restart(session.options().robotId())));
    WindowActions windowActions = new WindowActions(actions);
    windowActions.addViews(docks, List.copyOf(views.screens().keySet()));
    windowActions.addDocks(docks);
    windowActions.addLook(look);
    CommandPalette palette = new CommandPalette(actions, docks.component());
    KeyEditor keyEditor = new KeyEditor(actions, docks.component());
    actions.add(
        Action.of("help.palette", "Find an action\u2026", "control shift P", palette::open));
    actions.add(Action.of("help.keys", "Change keys\u2026", "", keyEditor::open));
  }

  private void build() {
    JPanel middle = new JPanel(new BorderLayout());
    middle.add(notices, BorderLayout.NORTH);
    middle.add(docks.component(), BorderLayout.CENTER);
    JPanel south = new JPanel(new BorderLayout());
    south.add(status, BorderLayout.NORTH);
    south.add(footer, BorderLayout.CENTER);
    frame.add(header, BorderLayout.NORTH);
    frame.add(rail(), BorderLayout.WEST);
    frame.add(middle, BorderLayout.CENTER);
    frame.add(south, BorderLayout.SOUTH);
    frame.setJMenuBar(new Menus(actions, files::recent, files::open).bar());
    frame.setName("pendant");
    frame.setDefaultCloseOperation(JFrame.DO_NOTHING_ON_CLOSE);
    frame.setMinimumSize(new Dimension(720, 480));
    frame.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosing(WindowEvent event) {
            close();
          }
        });
    frame.setBounds(remembered());
  }

  private Rail rail() {
    Rail rail = new Rail(docks::show, docks::moveMenu);
    for (View view : docks.views()) {
      if (views.screens().containsKey(view.id())) {
        rail.add(
            view,
            views.screens().get(view.id()),
            KeyText.shown(actions.keysOf("view." + view.id())));
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
    look.addListener(this::updateHiddenViews);
  }

  private void showProgram() {
    header.show(programs.current());
    String mark = programs.current().modified() ? "\u2022 " : "";
    frame.setTitle(mark + programs.current().name() + " - Pendant");
  }

  /** Views that are not in front are not reached by a change of the look. */
  private void updateHiddenViews() {
    for (View view : docks.views()) {
      if (SwingUtilities.getWindowAncestor(view.component()) == null) {
        SwingUtilities.updateComponentTreeUI(view.component());
      }
    }
  }

  private Rectangle remembered() {
    Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
    return WindowBounds.parse(settings.get("window.bounds").orElse(""))
        .filter(bounds -> bounds.intersects(screen))
        .orElseGet(() -> WindowBounds.usual(screen));
  }

  /** Shows the window. */
  void open() {
    if (settings.get("window.maximized").map(Boolean::parseBoolean).orElse(false)) {
      frame.setExtendedState(Frame.MAXIMIZED_BOTH);
    }
    showProgram();
    header.showRobot(session.options().robotId());
    refresh();
    frame.setVisible(true);
    docks.mainView().ifPresent(docks::show);
    refresh.start();
    keep.start();
    keeper.offerLeftBehind();
  }

  /** Opens a program. */
  void open(Path file) {
    files.open(file);
  }

  /** Tells something at the edge of the window. */
  void tell(String text) {
    status.tell(text);
  }

  private void refresh() {
    ControllerState state = session.state();
    keys.refresh();
    header.refresh(state);
    footer.refresh(state);
    status.refresh(session.lateness(), state.debug().held());
    popups.refresh(state);
    views.follow(state);
    for (View view : docks.views()) {
      if (view.component().isShowing()) {
        view.refresh(state);
      }
    }
    Optional<Throwable> failure = session.failure();
    if (failure.isPresent() && !failureTold) {
      status.tell("The controller has failed, an internal error: " + failure.get());
    }
    failureTold = failure.isPresent();
  }

  private void chooseRobot(String id) {
    if (id.equals(session.options().robotId())) {
      return;
    }
    if (!ProgramControls.of(session.state()).canStop()) {
      restart(id);
      return;
    }
    notices.ask(
        "robot-change",
        "Another robot ends the program that runs.",
        List.of(
            new Choice("Change robot", () -> restart(id)),
            new Choice("Keep", () -> header.showRobot(session.options().robotId()))));
  }

  private void restart(String id) {
    Background.run(
        () -> {
          session.restart(session.options().withRobot(id));
          return id;
        },
        done -> {
          settings.put(ROBOT, id);
          header.showRobot(id);
          status.tell("The controller was switched on with another arm: " + id);
        },
        failed -> status.tell(failed.getMessage()));
  }

  /** Closes the window, after asking for what is not saved. */
  void close() {
    List<ProgramDocument> unsaved =
        new ArrayList<>(programs.all().stream().filter(ProgramDocument::modified).toList());
    if (unsaved.isEmpty()) {
      dispose();
      return;
    }
    String names = String.join(", ", unsaved.stream().map(ProgramDocument::name).toList());
    notices.ask(
        "unsaved",
        "Not saved: " + names,
        List.of(
            new Choice("Save", () -> unsaved.forEach(files::save)),
            new Choice("Quit without saving", this::dispose),
            new Choice("Cancel", () -> {})));
  }

  private void dispose() {
    refresh.stop();
    keep.stop();
    boolean maximized = (frame.getExtendedState() & Frame.MAXIMIZED_BOTH) == Frame.MAXIMIZED_BOTH;
    settings.put("window.maximized", Boolean.toString(maximized));
    if (!maximized) {
      settings.put("window.bounds", WindowBounds.format(frame.getBounds()));
    }
    keeper.end();
    frame.dispose();
    closed.run();
  }
}
