package org.pendant.desktop.log;

import static org.pendant.desktop.log.LogTexts.text;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.ActionEvent;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.IntConsumer;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.KeyStroke;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.unit.FormMemory;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.Action;
import org.pendant.kit.export.SaveDialog;
import org.pendant.kit.export.SaveRequest;

/**
 * Log view: the screen of messages: bar above, table in the middle, the whole of one message below.
 */
public final class LogView implements View {
  private static final String ID = "log";

  private final Workbench workbench;
  private final IntConsumer showLine;
  private final LogPresenter presenter = new LogPresenter();
  private final LogMailbox mailbox;
  private final LogTable table;
  private final LogBar bar;
  private final LogDetail detail;
  private final JPanel content = new JPanel(new BorderLayout());
  private Optional<List<LogLine>> recorded = Optional.empty();
  private OptionalDouble looking = OptionalDouble.empty();

  /** A log whose lines lead to the current program. */
  public LogView(Workbench workbench) {
    this(workbench, line -> workbench.showSource(line, 1));
  }

  /**
   * A log without messages; {@link #refresh} brings them.
   *
   * @param showLine shows a line, from 1, of the program that was started last
   */
  public LogView(Workbench workbench, IntConsumer showLine) {
    this.workbench = workbench;
    this.showLine = showLine;
    RobotSession session = workbench.session();
    mailbox =
        new LogMailbox(
            LogPresenter.KEPT, number -> session.robot().logSince(number), InstantSource.system());
    session.addCellListener(mailbox);
    detail = new LogDetail(presenter.runs(), this::showSource);
    LogColumns columns = new LogColumns(workbench.settings());
    table = new LogTable(presenter, columns, this::selected, this::showSource);
    bar = new LogBar(this::filter, this::search, this::step);
    content.setName("log-view");
    content.getAccessibleContext().setAccessibleName(title());
    content.add(bar.component(), BorderLayout.NORTH);
    content.add(split(), BorderLayout.CENTER);
    declareActions();
    bar.addFollowing(table::follow);
    bar.addCommands(
        this::copy, this::export, this::clear, name -> workbench.actions().keysOf(ID + "." + name));
    LogMenus menus = new LogMenus(columns, table::columnsChanged);
    table.setMenu(menus.ofMessages(this::copy, table::showSelectedSource));
    bar.addColumns(menus.ofColumns());
    showCounts();
  }

  /**
   * A program starts on the controller that is shown, or an earlier one goes on.
   *
   * @param places what its lines are called in the messages that come from now on
   */
  public void startsRun(LogPlaces places) {
    presenter.runs().start(mailbox.newest(), workbench.session().shown().name(), places);
  }

  /** Keeps what the window tells, with the other messages. */
  public void told(String text) {
    if (!text.isBlank()) {
      mailbox.told(text);
    }
  }

  /** Keeps that a client of the ports has come or left; any thread. */
  public void visited(String text) {
    mailbox.happened(text);
  }

  /** Selects what was the newest at a time, robot time in s, and dims what came later. */
  public void lookAt(double timeS) {
    looking = OptionalDouble.of(timeS);
    int row = presenter.lookAt(timeS, table.selectedRow());
    table.select(row);
    presenter.follow(false);
    table.repaint();
  }

  /**
   * Shows the log of a recording instead of what comes, or no longer.
   *
   * @param places what the lines of its programs are called
   */
  public void showRecorded(Optional<List<LogEntry>> log, LogPlaces places) {
    presenter.runs().setRecorded(log.map(each -> places));
    recorded = log.map(LogView::lines);
    table.keepingSelection(presenter::restart);
    LogPresenter.Change change = take();
    table.changed(change);
    showCounts();
  }

  private static List<LogLine> lines(List<LogEntry> log) {
    List<LogLine> lines = new ArrayList<>();
    for (LogEntry each : log) {
      lines.add(LogLine.of(lines.size() + 1L, LogLine.NO_WALL, LogSource.of(each.origin()), each));
    }
    return lines;
  }

  private LogPresenter.Change take() {
    return recorded
        .map(
            lines ->
                presenter.take(lines.size(), after -> lines.subList((int) after, lines.size())))
        .orElseGet(() -> presenter.take(mailbox.newest(), mailbox::since));
  }

  /** Shows all messages in the units that people have chosen now. */
  private void takeUnits() {
    PoseForm form = FormMemory.read(workbench.settings());
    if (!form.equals(presenter.form())) {
      table.keepingSelection(() -> presenter.setForm(form));
      showCounts();
    }
  }

  /** Ends {@link #lookAt}. */
  public void lookAtNow() {
    looking = OptionalDouble.empty();
    int before = presenter.lookAtNow();
    table.clearSelection();
    table.jumpToNewest();
    table.select(before);
    table.repaint();
  }

  private JSplitPane split() {
    JSplitPane split = new LogSplit(table.component(), detail.component());
    split.setName("log-split");
    split.setBorder(BorderFactory.createEmptyBorder());
    split.getTopComponent().setMinimumSize(new Dimension(0, 0));
    return split;
  }

  /** Messages above, one of them below, in a ratio that stays however little room docks leave. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class LogSplit extends JSplitPane {
    private static final double MESSAGES = 0.7;

    private boolean placed;

    LogSplit(JComponent messages, JComponent message) {
      super(VERTICAL_SPLIT, messages, message);
      setResizeWeight(MESSAGES);
    }

    @Override
    public void doLayout() {
      if (!placed && getHeight() > 0) {
        placed = true;
        setDividerLocation(MESSAGES);
      }
      super.doLayout();
    }
  }

  private void declareActions() {
    var actions = workbench.actions();
    actions.add(Action.of(ID + ".search", text("logSearch"), "", this::goToSearch));
    actions.add(Action.of(ID + ".newest", text("logJumpToNewest"), "", table::jumpToNewest));
    actions.add(Action.of(ID + ".export", text("logExport"), "", this::export));
    actions.add(Action.of(ID + ".clear", text("logClear"), "", this::clear));
    actions.add(
        Action.of(
                ID + ".follow",
                text("logFollowNewest"),
                "",
                () -> table.follow(!presenter.following()))
            .checked(presenter::following));
    key("control F", "log-search", bar::focusSearch);
    key("F3", "log-next-match", () -> step(true));
    key("shift F3", "log-previous-match", () -> step(false));
    table.key("control C", "log-copy", this::copy);
  }

  private void goToSearch() {
    workbench.show(ID);
    bar.focusSearch();
  }

  private void key(String keys, String name, Runnable run) {
    content
        .getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
        .put(KeyStroke.getKeyStroke(keys), name);
    content.getActionMap().put(name, act(run));
  }

  static javax.swing.Action act(Runnable run) {
    return new RunningAction(run);
  }

  @SuppressWarnings("serial") // never written to a stream
  private static final class RunningAction extends AbstractAction {
    private final Runnable run;

    RunningAction(Runnable run) {
      this.run = run;
    }

    @Override
    public void actionPerformed(ActionEvent event) {
      run.run();
    }
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return text("logTitle");
  }

  @Override
  public JComponent component() {
    return content;
  }

  @Override
  public void refresh(ControllerState state) {
    takeUnits();
    LogPresenter.Change change = take();
    if (!change.none()) {
      table.changed(change);
      showCounts();
      looking.ifPresent(this::lookAt);
    }
    bar.showFollowing(presenter.following());
  }

  private void filter(LogFilter wanted) {
    table.keepingSelection(() -> presenter.setFilter(wanted));
    showCounts();
  }

  private void search(String wanted) {
    presenter.setSearch(wanted);
    detail.mark(presenter.search());
    if (!wanted.isEmpty() && presenter.matchNumber(table.selectedRow()) == 0) {
      table.select(presenter.previousMatch(presenter.rows()));
    }
    table.repaint();
    showCounts();
  }

  private void step(boolean forward) {
    int row = table.selectedRow();
    table.select(forward ? presenter.nextMatch(row) : presenter.previousMatch(row));
    showCounts();
  }

  private void selected() {
    int row = table.selectedRow();
    if (row < 0) {
      detail.showNone();
    } else {
      detail.show(presenter.row(row));
    }
    showCounts();
  }

  private void showSource(LogLine line) {
    RobotSession session = workbench.session();
    if (session.members().stream().anyMatch(each -> each.name().equals(line.controller()))) {
      session.show(line.controller());
    }
    presenter
        .runs()
        .of(line)
        .ifPresentOrElse(place -> place.show().run(), () -> line.sourceLine().ifPresent(showLine));
  }

  private LogExport.Row exported(LogLine line) {
    return new LogExport.Row(line, presenter.runs().brief(line));
  }

  private void copy() {
    int[] rows = table.selectedRows();
    List<LogLine> lines = Arrays.stream(rows).mapToObj(presenter::row).toList();
    if (lines.isEmpty()) {
      workbench.notify(text("nothingCopiedNoMessageIsSelected"));
      return;
    }
    StringBuilder text = new StringBuilder();
    lines.forEach(line -> text.append(LogExport.TEXT.row(exported(line))));
    detail.copy(text.toString());
    workbench.notify(
        lines.size() == 1 ? text("copied1Message") : text("copiedMessages", lines.size()));
  }

  private void export() {
    List<LogExport.Row> rows = new ArrayList<>();
    for (int row = 0; row < presenter.rows(); row++) {
      rows.add(exported(presenter.row(row)));
    }
    SaveDialog.open(
        content,
        new SaveRequest(
            text("exportMessages", rows.size()),
            workbench.exportFile("log.csv"),
            List.of("csv", "txt"),
            workbench.openFiles()),
        file -> LogExport.forFile(file).write(rows, file),
        workbench::notify);
  }

  private void clear() {
    table.keepingSelection(presenter::clear);
    selected();
  }

  private void showCounts() {
    bar.showCounts(LogCounts.of(presenter, table.selectedRow()));
    table.showUnread();
    bar.showFollowing(presenter.following());
  }
}
