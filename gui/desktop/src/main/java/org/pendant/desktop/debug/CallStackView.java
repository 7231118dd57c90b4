package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Font;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.table.DefaultTableCellRenderer;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.KeyText;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.table.RowsModel;
import org.pendant.kit.theme.Markup;
import org.pendant.kit.theme.Palette;
import org.pendant.script.debug.DebugState;

/** Call stack view: all script threads of a program that is paused, and their calls. */
public final class CallStackView implements View {
  /** Its name in settings and commands. */
  public static final String ID = "call-stack";

  /** What people read on its tab. */
  public static final String TITLE = text("callStack");

  private static final String NOTE = text("noProgramRunsTheThreadsOf");

  private static final String PAST_NOTE = text("aRecordingHasThreadsAndCalls");

  private final Workbench workbench;
  private final DebugPresenter debug;
  private final Rows rows = new Rows();
  private final JTable table = new JTable(rows);
  private final DebugPanel panel;
  private final JButton kill = new JButton(text("endThread"));
  private final JCheckBox onErrors = new JCheckBox(text("stopAtErrors"));
  private final JButton hold;
  private final JButton resume;
  private final List<JButton> steps;
  private boolean showing;
  private Supplier<Optional<ControllerState>> past = Optional::empty;
  private IntFunction<String> pastPlaces;
  private Optional<DebugState> shownPast = Optional.empty();

  /** Without threads yet. */
  public CallStackView(Workbench workbench, DebugPresenter debug) {
    assert EventQueue.isDispatchThread();
    this.workbench = workbench;
    this.debug = debug;
    pastPlaces = debug::place;
    hold = button(text("pauseAll"), "debug.pause", text("pausesAllThreadsToLookAt"));
    resume = button(text("resume"), "program.run", text("resumesTheProgram"));
    resume.setName("call-stack-resume");
    steps =
        List.of(
            button(text("stepOverShort"), "debug.step-over", text("stepOverToTheNextStatement")),
            button(text("stepIntoShort"), "debug.step-into", text("stepIntoToTheNextStatement")),
            button(text("stepOutShort"), "debug.step-out", text("stepOutToTheNextStatement")));
    setUpTable();
    JPanel content = new JPanel(new BorderLayout());
    content.add(buttons(), BorderLayout.NORTH);
    content.add(new JScrollPane(table));
    panel = new DebugPanel("call-stack", content);
    debug.addListener(this::show);
    show();
  }

  /**
   * Has the calls of a moment of the past shown, while there is one.
   *
   * @param places what a line of the program of that moment is called in a sentence
   */
  public void setPast(Supplier<Optional<ControllerState>> moment, IntFunction<String> places) {
    past = moment;
    pastPlaces = places;
  }

  private void setUpTable() {
    table.setName("call-stack-table");
    table.getAccessibleContext().setAccessibleName(text("threadsAndCalls"));
    table.setToolTipText(text("selectACallToSeeIts"));
    table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    table.setShowGrid(false);
    table.setFillsViewportHeight(true);
    DebugPanel.alignTitles(table);
    table.setDefaultRenderer(Object.class, new Cell());
    table.getColumnModel().getColumn(0).setPreferredWidth(200);
    table.getColumnModel().getColumn(1).setPreferredWidth(200);
    table.getSelectionModel().addListSelectionListener(event -> choose());
    table.registerKeyboardAction(
        event -> killSelected(), KeyStroke.getKeyStroke("DELETE"), JComponent.WHEN_FOCUSED);
    JPopupMenu menu = new JPopupMenu();
    menu.add(VariablesView.item(text("endThread"), text("deleteKey"), this::killSelected));
    table.setComponentPopupMenu(menu);
  }

  private JComponent buttons() {
    JPanel row = new JPanel(new WrappingRow(8));
    row.add(hold);
    row.add(resume);
    steps.forEach(row::add);
    kill.setName("thread-end");
    kill.putClientProperty("JButton.buttonType", "toolBarButton");
    kill.setToolTipText(text("endsTheSelectedThreadAndThose"));
    kill.getAccessibleContext().setAccessibleName(text("endThread"));
    kill.addActionListener(event -> killSelected());
    row.add(kill);
    onErrors.setName("call-stack-break-on-errors");
    onErrors.setToolTipText(text("pausesAProgramThatFailsSo"));
    onErrors.addActionListener(event -> debug.breakpoints().setOnErrors(onErrors.isSelected()));
    debug.breakpoints().addListener(() -> onErrors.setSelected(debug.breakpoints().onErrors()));
    row.add(onErrors);
    return row;
  }

  private JButton button(String title, String action, String tip) {
    JButton button = new JButton(title);
    button.setName(action.replace('.', '-'));
    String keys = KeyText.shown(workbench.actions().keysOf(action));
    button.setToolTipText(keys.isEmpty() ? tip : tip + " (" + keys + ")");
    button.getAccessibleContext().setAccessibleName(tip);
    button.putClientProperty("JButton.buttonType", "toolBarButton");
    button.addActionListener(event -> workbench.actions().run(action));
    return button;
  }

  private Optional<CallRow> selectedRow() {
    int row = table.getSelectedRow();
    return row < 0 || row >= rows.getRowCount() ? Optional.empty() : Optional.of(rows.row(row));
  }

  private void choose() {
    if (showing || shownPast.isPresent()) {
      return;
    }
    selectedRow()
        .ifPresent(
            row -> {
              // A thread stands for its innermost call, which is the row below it.
              CallRow call = row.isThread() ? rows.row(table.getSelectedRow() + 1) : row;
              debug.select(call.thread(), call.depth());
            });
  }

  private void killSelected() {
    if (debug.steps().canKill()) {
      selectedRow().ifPresent(row -> debug.steps().kill(row.thread()));
    }
  }

  private void show() {
    enable();
    if (shownPast.isPresent()) {
      showPast(shownPast.get());
      return;
    }
    if (!debug.showsValues() && !debug.runsFree()) {
      rows.replace(List.of());
      panel.showNote(NOTE);
      return;
    }
    if (debug.held()) {
      panel.showContent(debug.stopText());
    } else {
      panel.showQuietly(running());
    }
    if (!debug.held() && debug.threads().isEmpty()) {
      return; // a step is over soon: what was there before stays meanwhile
    }
    showing = true;
    try {
      rows.replace(CallRow.of(debug.threads(), debug::place));
      table.setRowHeight(table.getFontMetrics(table.getFont()).getHeight() + 12);
      debug.selected().filter(scope -> debug.held()).ifPresent(this::mark);
    } finally {
      showing = false;
    }
  }

  private void showPast(DebugState then) {
    if (!then.held()) {
      rows.replace(List.of());
      panel.showNote(PAST_NOTE);
      return;
    }
    panel.showContent(debug.stopText(then.stop().orElseThrow()));
    rows.replace(CallRow.of(then.threads(), pastPlaces));
    table.setRowHeight(table.getFontMetrics(table.getFont()).getHeight() + 12);
  }

  private void enable() {
    Stepping stepping = debug.steps();
    hold.setEnabled(stepping.canPause());
    kill.setEnabled(stepping.canKill());
    steps.forEach(each -> each.setEnabled(stepping.canStep()));
    resume.setEnabled(debug.held() || stepping.canStep());
  }

  private String running() {
    String keys = KeyText.shown(workbench.actions().keysOf("debug.pause"));
    return keys.isEmpty() ? text("running") : text("runningWithKeys", keys);
  }

  private void mark(Scope scope) {
    for (int i = 0; i < rows.getRowCount(); i++) {
      CallRow row = rows.row(i);
      if (row.thread() == scope.thread() && row.depth() == scope.depth()) {
        table.setRowSelectionInterval(i, i);
        table.scrollRectToVisible(table.getCellRect(i, 0, true));
      }
    }
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return TITLE;
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public void refresh(ControllerState state) {
    debug.refresh(state);
    debug.lookAtThreads();
    Optional<DebugState> then = past.get().map(ControllerState::debug);
    if (!then.equals(shownPast)) {
      shownPast = then;
      show();
    }
    enable();
  }

  /** The rows. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class Rows extends RowsModel<CallRow> {
    Rows() {
      super(List.of(text("threadOrCall"), text("whereColumn")));
    }

    @Override
    protected Object cell(CallRow row, int column) {
      return row;
    }
  }

  /** Threads in bold, their calls below them. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class Cell extends DefaultTableCellRenderer {
    @Override
    public Component getTableCellRendererComponent(
        JTable table, Object value, boolean selected, boolean focused, int row, int column) {
      super.getTableCellRendererComponent(table, "", selected, focused, row, column);
      CallRow call = (CallRow) value;
      String text = column == 0 ? call.name() : call.place();
      setText(text);
      setIcon(column == 0 && !call.isThread() ? new DisclosureIcon(0, false, false) : null);
      setFont(call.isThread() ? table.getFont().deriveFont(Font.BOLD) : table.getFont());
      int width = table.getColumnModel().getColumn(column).getWidth();
      setToolTipText(getPreferredSize().width > width ? Markup.toolTip(text) : null);
      if (!selected) {
        setForeground(column == 0 ? table.getForeground() : Palette.quiet());
      }
      return this;
    }
  }
}
