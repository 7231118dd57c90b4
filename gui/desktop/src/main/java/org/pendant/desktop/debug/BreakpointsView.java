package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Optional;
import java.util.OptionalInt;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.table.TableCellEditor;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.editor.MarginMenu;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.background.WorkerThread;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.table.RowKeys;
import org.pendant.script.debug.Breakpoint;

/**
 * Breakpoints view: the breakpoints of the program in front; conditions and counts are changed in
 * place.
 */
public final class BreakpointsView implements View {
  /** Its name in settings and commands. */
  public static final String ID = "breakpoints";

  private static final String NOTE = text("noBreakpointsPressF9InThe");

  private final Workbench workbench;
  private final DebugPresenter debug;
  private final OpenBreakpoints openBreakpoints;
  private final BreakpointTableModel rows;
  private final ConditionCheck check;
  private final JTable table;
  private final JLabel refused = new JLabel();
  private final JCheckBox onErrors = new JCheckBox(text("stopAtErrors"));
  private final JButton remove = new JButton(text("remove"));
  private final DebugPanel list;
  private final JPanel panel = new JPanel(new BorderLayout());
  private OptionalInt wantedLine = OptionalInt.empty();
  private boolean fresh;
  private int wantedColumn = BreakpointTableModel.CONDITION;

  /** The breakpoints as they are. */
  public BreakpointsView(Workbench workbench, DebugPresenter debug) {
    assert EventQueue.isDispatchThread();
    this.workbench = workbench;
    this.debug = debug;
    openBreakpoints = debug.breakpoints();
    rows = new BreakpointTableModel(openBreakpoints);
    check =
        new ConditionCheck(
            new WorkerThread("conditions"),
            EventQueue::invokeLater,
            workbench.session().robot().builtins(),
            openBreakpoints::source);
    table = new JTable(rows);
    setUpTable();
    JScrollPane scroll = new JScrollPane(table);
    // What is refused takes room from the row that is edited.
    scroll.getViewport().addComponentListener(new Shrinking());
    list = new DebugPanel("breakpoints-content", scroll);
    panel.setName("breakpoints");
    panel.add(buttons(), BorderLayout.NORTH);
    panel.add(list);
    panel.add(refused, BorderLayout.SOUTH);
    refused.setName("breakpoints-refusal");
    refused.setBorder(BorderFactory.createEmptyBorder(4, 8, 4, 8));
    refused.setVisible(false);
    openBreakpoints.addListener(this::show);
    show();
  }

  private void setUpTable() {
    table.setName("breakpoints-table");
    table.getAccessibleContext().setAccessibleName(text("breakpoints"));
    table.setToolTipText(text("aDoubleClickOnTheLine"));
    table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    table.setShowGrid(false);
    table.setFillsViewportHeight(true);
    RowKeys.install(table);
    DebugPanel.alignTitles(table);
    table.putClientProperty("JTable.autoStartsEdit", false);
    table.putClientProperty("terminateEditOnFocusLost", true);
    width(BreakpointTableModel.ENABLED, 50);
    width(BreakpointTableModel.LINE, 110);
    width(BreakpointTableModel.CONDITION, 240);
    width(BreakpointTableModel.MESSAGE, 240);
    width(BreakpointTableModel.FROM_HIT, 80);
    width(BreakpointTableModel.HITS, 70);
    edit(
        BreakpointTableModel.CONDITION,
        ConditionEditor.ofConditions(refused, check, row -> rows.row(row).line()));
    edit(
        BreakpointTableModel.MESSAGE,
        ConditionEditor.ofMessages(refused, check, row -> rows.row(row).line()));
    edit(
        BreakpointTableModel.FROM_HIT,
        new CheckedField("breakpoint-from-hit", refused, BreakpointTableModel::hitRefusal));
    key("DELETE", this::removeSelected);
    key("ENTER", this::jump);
    key("SPACE", this::toggleSelected);
    key(
        "F2",
        () -> {
          int column = table.getSelectedColumn();
          boolean typed =
              column == BreakpointTableModel.FROM_HIT || column == BreakpointTableModel.MESSAGE;
          edit(table.getSelectedRow(), typed ? column : BreakpointTableModel.CONDITION);
        });
    table.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent event) {
            int column = table.columnAtPoint(event.getPoint());
            if (event.getClickCount() == 2 && !rows.isCellEditable(0, column)) {
              jump();
            }
          }
        });
    JPopupMenu menu = new JPopupMenu();
    menu.add(VariablesView.item(text("showLine"), text("enterKey"), this::jump));
    menu.add(VariablesView.item(text("changeCondition"), "F2", this::editCondition));
    menu.add(
        VariablesView.item(
            text("changeLogMessage"),
            text("f2InItsColumnLogsIt"),
            () -> edit(table.getSelectedRow(), BreakpointTableModel.MESSAGE)));
    menu.add(VariablesView.item(text("remove"), text("deleteKey"), this::removeSelected));
    table.setComponentPopupMenu(menu);
  }

  private void width(int column, int pixels) {
    table.getColumnModel().getColumn(column).setPreferredWidth(pixels);
    table.getColumnModel().getColumn(column).setMinWidth(Math.min(pixels, 80));
  }

  private void edit(int column, TableCellEditor editor) {
    table.getColumnModel().getColumn(column).setCellEditor(editor);
  }

  private void key(String stroke, Runnable run) {
    table.registerKeyboardAction(
        event -> run.run(), KeyStroke.getKeyStroke(stroke), JComponent.WHEN_FOCUSED);
  }

  private JComponent buttons() {
    onErrors.setName("break-on-errors");
    onErrors.setToolTipText(text("pausesAProgramThatFailsSo"));
    onErrors.getAccessibleContext().setAccessibleName(text("stopAtErrorsBeforeTheProgram"));
    onErrors.addActionListener(event -> openBreakpoints.setOnErrors(onErrors.isSelected()));
    remove.setName("breakpoint-remove");
    remove.setToolTipText(text("removesTheSelectedBreakpointDel"));
    remove.getAccessibleContext().setAccessibleName(text("removeBreakpoint"));
    remove.addActionListener(event -> removeSelected());
    JPanel row = new JPanel(new WrappingRow(8));
    row.add(onErrors);
    row.add(remove);
    return row;
  }

  private Optional<Breakpoint> selected() {
    int row = table.getSelectedRow();
    return row < 0 || row >= rows.getRowCount() ? Optional.empty() : Optional.of(rows.row(row));
  }

  private void jump() {
    selected().ifPresent(each -> workbench.showSource(each.line(), 1));
  }

  private void toggleSelected() {
    if (selected().isPresent()) {
      int row = table.getSelectedRow();
      rows.setValueAt(!rows.row(row).enabled(), row, BreakpointTableModel.ENABLED);
    }
  }

  private void editCondition() {
    edit(table.getSelectedRow(), BreakpointTableModel.CONDITION);
  }

  private void edit(int row, int column) {
    if (row >= 0 && table.editCellAt(row, column)) {
      table.scrollRectToVisible(table.getCellRect(row, column, true));
      table.getEditorComponent().requestFocusInWindow();
    }
  }

  private void removeSelected() {
    selected().ifPresent(each -> openBreakpoints.toggle(each.line()));
  }

  /**
   * Edits the condition of the breakpoint of a line, or of the next one where the program can stop,
   * as soon as there is one.
   */
  public void editCondition(int line) {
    editLine(line, BreakpointTableModel.CONDITION);
  }

  /** As {@link #editCondition}, for the message that is logged instead of stopping. */
  public void editMessage(int line) {
    editLine(line, BreakpointTableModel.MESSAGE);
  }

  /** What can be done beside a line. */
  public MarginMenu marginMenu() {
    return new BreakpointMenu(openBreakpoints, this::editCondition, this::editMessage);
  }

  private void editLine(int line, int column) {
    workbench.show(ID);
    wantedLine = OptionalInt.of(line);
    wantedColumn = column;
    fresh = openBreakpoints.at(line).isEmpty();
    openBreakpoints.ensure(line);
    show();
  }

  private void editWanted(int line) {
    for (int i = 0; i < rows.getRowCount(); i++) {
      if (rows.row(i).line() >= line) {
        wantedLine = OptionalInt.empty();
        if (fresh && wantedColumn == BreakpointTableModel.MESSAGE) {
          // It must not stop a program that runs while people still type.
          Breakpoint row = rows.row(i);
          openBreakpoints.change(row.logging(ConditionEditor.firstMessage(row.line())));
        }
        table.setRowSelectionInterval(i, i);
        EventQueue.invokeLater(() -> edit(table.getSelectedRow(), wantedColumn));
        return;
      }
    }
  }

  private void show() {
    if (table.isEditing() && rows.getRowCount() != openBreakpoints.all().size()) {
      table.getCellEditor().cancelCellEditing();
    }
    rows.show();
    table.setRowHeight(table.getFontMetrics(table.getFont()).getHeight() + 12);
    onErrors.setSelected(openBreakpoints.onErrors());
    remove.setEnabled(rows.getRowCount() > 0);
    if (rows.getRowCount() == 0) {
      list.showNote(NOTE);
    } else {
      list.showContent("");
      wantedLine.ifPresent(this::editWanted);
    }
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return text("breakpoints");
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public void refresh(ControllerState state) {
    debug.refresh(state);
    debug.lookAtHits();
  }

  /** Keeps the row that is edited in sight. */
  private final class Shrinking extends ComponentAdapter {
    @Override
    public void componentResized(ComponentEvent event) {
      if (table.isEditing()) {
        table.scrollRectToVisible(
            table.getCellRect(table.getEditingRow(), table.getEditingColumn(), true));
      }
    }
  }
}
