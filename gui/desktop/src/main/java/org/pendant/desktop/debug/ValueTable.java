package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import javax.swing.CellRendererPane;
import javax.swing.DefaultCellEditor;
import javax.swing.JComponent;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.SwingUtilities;
import javax.swing.table.TableColumn;
import org.pendant.language.source.ByteText;

/**
 * Value table: a {@link ValueTree} on the screen. Right and left unfold and fold, F2 and a double
 * click edit, Enter unfolds or shows more, and values can be dragged to where expressions are
 * taken.
 */
@SuppressWarnings("serial") // never written to a stream
final class ValueTable extends JTable {
  private static final int MARGIN = 6;

  /** Names of so many letters are whole before values and kinds get more. */
  private static final int NAME_LETTERS = 16;

  private final ValueTree tree;
  private final ValueTableModel model;
  private final ValueCell cell = new ValueCell();
  private final Optional<Consumer<ValueRow.Value>> star;
  private final CellRendererPane pane = new CellRendererPane();
  private List<ValueRow> shown = List.of();
  private Optional<ValueKey> lastSelected = Optional.empty();

  /**
   * A table of the values of {@code tree}.
   *
   * @param namesEditable whether the names of those that are part of nothing can be changed
   * @param rename changes one
   * @param star makes a variable a favourite, or no longer one; empty if none can be
   */
  ValueTable(
      String name,
      ValueTree tree,
      boolean namesEditable,
      BiConsumer<ValueRow.Value, String> rename,
      Optional<Consumer<ValueRow.Value>> star) {
    assert EventQueue.isDispatchThread();
    this.tree = tree;
    this.star = star;
    model = new ValueTableModel(tree, namesEditable, rename, star.isPresent());
    setModel(model);
    setName(name);
    setDefaultRenderer(Object.class, cell);
    setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    setFillsViewportHeight(true);
    setShowGrid(false);
    putClientProperty("JTable.autoStartsEdit", false);
    putClientProperty("terminateEditOnFocusLost", true);
    setSurrendersFocusOnKeystroke(true);
    JTextField field = new JTextField();
    field.setName(name + "-field");
    field.getAccessibleContext().setAccessibleName(text("newValueAnyExpression"));
    field.putClientProperty("FlatLaf.styleClass", "monospaced");
    DefaultCellEditor editor = new DefaultCellEditor(field);
    editor.setClickCountToStart(2);
    setDefaultEditor(Object.class, editor);
    width(ValueTableModel.NAME, 150);
    width(ValueTableModel.VALUE, 260);
    width(ValueTableModel.KIND, 96);
    if (star.isPresent()) {
      TableColumn stars = getColumnModel().getColumn(ValueTableModel.STAR);
      int side = 2 * getFontMetrics(getFont()).getHeight();
      stars.setMinWidth(side);
      stars.setMaxWidth(side);
    }
    bindKeys();
    addMouseListener(new Clicks());
    setDragEnabled(true);
    setTransferHandler(new ExpressionTransfer(Optional.empty()));
    addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            fitHeights();
          }
        });
    tree.addListener(this::showRows);
    showRows();
  }

  private void width(int column, int pixels) {
    getColumnModel().getColumn(column).setPreferredWidth(pixels);
  }

  @Override
  public void doLayout() {
    if (getTableHeader() == null || getTableHeader().getResizingColumn() == null) {
      fitNames();
    }
    super.doLayout();
  }

  /** Names have at most the half of a table that is narrower still. */
  private void fitNames() {
    TableColumn names = getColumnModel().getColumn(ValueTableModel.NAME);
    int wanted = Math.min(cell.nameWidth(NAME_LETTERS, this), getWidth() / 2);
    names.setMinWidth(wanted);
    names.setPreferredWidth(Math.max(names.getPreferredWidth(), wanted));
  }

  ValueRow row(int index) {
    return model.row(index);
  }

  /** The value that is selected. */
  Optional<ValueRow.Value> selectedValue() {
    int row = getSelectedRow();
    return row >= 0 && row(row) instanceof ValueRow.Value value
        ? Optional.of(value)
        : Optional.empty();
  }

  /** Has {@code listener} hear the expression of each value that people select or come back to. */
  void whenSelected(Consumer<String> listener) {
    getSelectionModel().addListSelectionListener(event -> tellSelected(listener));
    addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusGained(FocusEvent event) {
            tellSelected(listener);
          }
        });
  }

  private void tellSelected(Consumer<String> listener) {
    if (isFocusOwner()) {
      selectedValue().map(ValueTable::expression).ifPresent(listener);
    }
  }

  /** Selects the first value there is. */
  void selectFirstValue() {
    for (int i = 0; i < shown.size(); i++) {
      if (shown.get(i) instanceof ValueRow.Value) {
        setRowSelectionInterval(i, i);
        return;
      }
    }
  }

  private void showRows() {
    if (shown.equals(tree.rows())) {
      return;
    }
    if (ValueRow.sameLines(shown, tree.rows())) {
      shown = tree.rows();
      model.show(shown);
      return;
    }
    int selected = getSelectedRow();
    selectedValue().ifPresent(value -> lastSelected = Optional.of(value.key()));
    if (isEditing()) {
      getCellEditor().cancelCellEditing();
    }
    shown = tree.rows();
    model.replace(shown);
    fitHeights();
    select(selected);
  }

  /** Selects the value that was selected, wherever it is now, or what is in its place. */
  private void select(int place) {
    for (int i = 0; i < shown.size(); i++) {
      if (lastSelected.isPresent()
          && shown.get(i) instanceof ValueRow.Value value
          && value.key().equals(lastSelected.get())) {
        setRowSelectionInterval(i, i);
        return;
      }
    }
    if (place >= 0 && !shown.isEmpty()) {
      int row = Math.min(place, shown.size() - 1);
      setRowSelectionInterval(row, row);
    }
  }

  private void fitHeights() {
    int usual = getFontMetrics(getFont()).getHeight() + 2 * MARGIN;
    setRowHeight(usual);
    for (int i = 0; i < shown.size(); i++) {
      if (shown.get(i) instanceof ValueRow.Problem problem) {
        setRowHeight(i, Math.max(usual, cell.problemHeight(problem, this)));
      }
    }
  }

  @Override
  public void updateUI() {
    super.updateUI();
    if (cell != null) {
      cell.updateUI();
      fitHeights();
    }
  }

  /** Writes all that is no value over the full width; its cells are empty. */
  @Override
  protected void paintComponent(Graphics g) {
    super.paintComponent(g);
    Rectangle clip = g.getClipBounds();
    int first = Math.max(0, rowAtPoint(new Point(0, clip.y)));
    for (int i = first; i < shown.size(); i++) {
      Rectangle row = getCellRect(i, 0, true);
      if (row.y > clip.y + clip.height) {
        return;
      }
      if (!(shown.get(i) instanceof ValueRow.Value) && getEditingRow() != i) {
        Component line = cell.line(shown.get(i), this, isRowSelected(i));
        SwingUtilities.paintComponent(g, line, pane, 0, row.y, getWidth(), row.height);
      }
    }
  }

  private void bindKeys() {
    key("RIGHT", () -> unfold(true));
    key("LEFT", () -> unfold(false));
    key("ENTER", this::activate);
    key("control C", this::copyValue);
    key("F2", this::editValue);
    key("S", this::toggleStar);
  }

  private void key(String stroke, Runnable run) {
    registerKeyboardAction(
        event -> run.run(), KeyStroke.getKeyStroke(stroke), JComponent.WHEN_FOCUSED);
  }

  private void unfold(boolean wanted) {
    selectedValue().filter(value -> value.unfolded() != wanted).ifPresent(tree::toggle);
  }

  private void activate() {
    if (getSelectedRow() < 0) {
      return;
    }
    switch (row(getSelectedRow())) {
      case ValueRow.Value value when value.hasParts() -> tree.toggle(value);
      case ValueRow.Value value -> editValue();
      case ValueRow.More more -> tree.showMore(more);
      case ValueRow.Problem problem -> tree.dismiss(problem.key());
      case ValueRow.Heading heading -> {}
    }
  }

  /** Edits the value of the selected row. */
  void editValue() {
    edit(ValueTableModel.VALUE);
  }

  /** Edits a column of the selected row, if that can be changed. */
  void edit(int column) {
    if (getSelectedRow() >= 0 && editCellAt(getSelectedRow(), column)) {
      getEditorComponent().requestFocusInWindow();
    }
  }

  /** Makes the selected variable a favourite, or no longer one. */
  void toggleStar() {
    selectedValue().filter(value -> value.level() == 0).ifPresent(this::toggleStar);
  }

  private void toggleStar(ValueRow.Value value) {
    star.ifPresent(each -> each.accept(value));
  }

  /** Why a value cannot be changed now; empty if it can. */
  String whyFixed(ValueRow.Value value) {
    return tree.whyFixed(value);
  }

  /** Copies the value of the selected row. */
  void copyValue() {
    selectedValue().ifPresent(value -> copy(value.text()));
  }

  /** Copies the expression of the selected row. */
  void copyExpression() {
    selectedValue().ifPresent(value -> copy(expression(value)));
  }

  /** What yields a value, as people write it. */
  static String expression(ValueRow.Value value) {
    return ByteText.decoded(value.key().expression());
  }

  private static void copy(String text) {
    Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new StringSelection(text), null);
  }

  /** Presses on arrows and on rows for more. */
  private final class Clicks extends MouseAdapter {
    @Override
    public void mousePressed(MouseEvent event) {
      int index = rowAtPoint(event.getPoint());
      if (index < 0) {
        return;
      }
      if (event.isPopupTrigger() || event.getButton() != MouseEvent.BUTTON1) {
        setRowSelectionInterval(index, index);
        return;
      }
      switch (row(index)) {
        case ValueRow.Value value when value.hasParts() && onArrow(value, event.getX()) ->
            tree.toggle(value);
        case ValueRow.More more -> tree.showMore(more);
        case ValueRow.Value value when onStar(value, event) -> toggleStar(value);
        case ValueRow.Value value -> {}
        case ValueRow.Heading heading -> {}
        case ValueRow.Problem problem -> {}
      }
    }

    private boolean onStar(ValueRow.Value value, MouseEvent event) {
      int column = columnAtPoint(event.getPoint());
      return value.level() == 0
          && column >= 0
          && convertColumnIndexToModel(column) == ValueTableModel.STAR;
    }

    private boolean onArrow(ValueRow.Value value, int x) {
      return x < DisclosureIcon.end(value.level()) && x >= DisclosureIcon.end(value.level() - 1);
    }
  }
}
