package org.pendant.desktop.sweep;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.RowSorter;
import javax.swing.SortOrder;
import javax.swing.SwingConstants;
import javax.swing.table.AbstractTableModel;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.TableRowSorter;
import org.pendant.kit.table.TableLook;
import org.pendant.kit.text.Messages;
import org.pendant.sweep.run.ProgramNodes;
import org.pendant.sweep.run.RunOutcome;
import org.pendant.sweep.table.CellType;
import org.pendant.sweep.table.ResultColumn;

/** Run table: the rows of a sweep, which can be sorted by any column while they come. */
@SuppressWarnings("serial") // never written to a stream
final class RunTable extends JTable {
  private static final String LINE = "line";
  private static final List<String> USUAL =
      List.of(
          "duration",
          "torque_share",
          "speed_share",
          "tool_speed",
          "joint_limit",
          "plane",
          "singularity",
          "force",
          "energy",
          LINE,
          "reason");
  private static final int ROW_SPACE = 6;
  private static final int NUMBER_WIDTH = 76;
  private static final int WORD_WIDTH = 100;
  private static final int MARK = 36;

  private final Model model;
  private final transient Consumer<RunRow> open;
  private transient Optional<RunRows> rows = Optional.empty();
  private transient Optional<ProgramNodes> nodes = Optional.empty();
  private boolean allColumns;

  /**
   * An empty table.
   *
   * @param open shows a run: Enter or a double click
   */
  RunTable(Consumer<RunRow> open) {
    this(new Model(), open);
  }

  private RunTable(Model model, Consumer<RunRow> open) {
    super(model);
    this.model = model;
    TableLook.apply(this, "sweep-rows", SweepTexts.text("runsOfTheSweep"));
    this.open = open;
    setAutoResizeMode(AUTO_RESIZE_OFF);
    setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
    setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
    setDefaultRenderer(Object.class, new Cell());
    setDefaultRenderer(Double.class, new Cell());
    registerKeyboardAction(event -> openSelected(), KeyStroke.getKeyStroke("ENTER"), WHEN_FOCUSED);
    addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent event) {
            if (event.getClickCount() == 2 && rowAtPoint(event.getPoint()) >= 0) {
              openSelected();
            }
          }
        });
  }

  @Override
  public void updateUI() {
    super.updateUI();
    TableLook.fitRows(this, ROW_SPACE);
  }

  void openSelected() {
    selected().ifPresent(open);
  }

  /** The run of the selected row. */
  Optional<RunRow> selected() {
    int row = getSelectedRow();
    return row < 0 ? Optional.empty() : Optional.of(model.row(convertRowIndexToModel(row)));
  }

  /** Selects a run and brings it in sight. */
  void select(int place) {
    int row = convertRowIndexToView(place);
    if (row >= 0) {
      setRowSelectionInterval(row, row);
      scrollRectToVisible(getCellRect(row, 0, true));
    }
  }

  void setAllColumns(boolean on) {
    allColumns = on;
    begin();
  }

  /** Calls lines of the program by the nodes of its tree from now on, if it is one. */
  void nameLinesBy(Optional<ProgramNodes> names) {
    nodes = names;
  }

  /** The node of a line; empty for other columns and for scripts. */
  private Optional<String> node(ResultColumn column, double number) {
    return nodes
        .filter(each -> column.name().equals(LINE))
        .flatMap(each -> each.at((int) number))
        .map(each -> SweepTexts.text("node", each.number(), each.label()));
  }

  /** Shows rows, which may grow. */
  void show(Optional<RunRows> wanted, int parameters) {
    if (!wanted.equals(rows) || model.parameters != parameters) {
      rows = wanted;
      model.parameters = parameters;
      begin();
    } else {
      model.grow();
    }
  }

  private void begin() {
    model.begin(rows, allColumns);
    setRowSorter(null);
    model.fireTableStructureChanged();
    TableRowSorter<Model> sorter = new TableRowSorter<>(model);
    for (int i = 0; i < model.getColumnCount(); i++) {
      if (!model.text(i)) {
        sorter.setComparator(i, Comparator.<Double>naturalOrder());
      }
      getColumnModel().getColumn(i).setPreferredWidth(width(i));
    }
    setRowSorter(sorter);
    if (model.getColumnCount() > 0) {
      sorter.setSortKeys(List.of(new RowSorter.SortKey(0, SortOrder.ASCENDING)));
    }
  }

  /** At least that of the title, which has a mark when it sorts. */
  private int width(int column) {
    int title =
        getFontMetrics(getFont()).stringWidth(model.getColumnName(column)) + UIScale.scale(MARK);
    return column == 0
        ? title
        : Math.max(title, UIScale.scale(words(column) ? WORD_WIDTH : NUMBER_WIDTH));
  }

  private boolean words(int column) {
    return model.text(column) || (nodes.isPresent() && model.column(column).name().equals(LINE));
  }

  @Override
  public String getToolTipText(MouseEvent event) {
    int row = rowAtPoint(event.getPoint());
    int column = columnAtPoint(event.getPoint());
    if (row < 0 || column < 0) {
      return null;
    }
    ResultColumn of = model.column(convertColumnIndexToModel(column));
    int place = model.shown.get(convertColumnIndexToModel(column));
    RunRow run = model.row(convertRowIndexToModel(row));
    String value = node(of, run.number(place)).orElseGet(() -> run.cell(place));
    String description = Messages.shown(of.description());
    return value.isEmpty()
        ? description
        : Messages.told(description, of.unit().isEmpty() ? value : value + " " + of.unit());
  }

  /** The rows that there were at the last look. */
  private static final class Model extends AbstractTableModel {
    private transient Optional<RunRows> rows = Optional.empty();
    private transient List<Integer> shown = List.of();
    private int size;
    private int parameters;

    void begin(Optional<RunRows> wanted, boolean all) {
      rows = wanted;
      size = wanted.map(RunRows::size).orElse(0);
      shown = wanted.map(each -> places(each, all)).orElse(List.of());
    }

    /** The number, the outcome, the parameters, then what matters most. */
    private List<Integer> places(RunRows of, boolean all) {
      List<Integer> places = new ArrayList<>();
      places.add(0);
      places.add(of.column("outcome"));
      for (int i = 1; i <= parameters; i++) {
        places.add(i);
      }
      USUAL.stream().map(of::column).filter(each -> each >= 0).forEach(places::add);
      for (int i = 0; i < of.columns().size(); i++) {
        String name = of.columns().get(i).name();
        if (!places.contains(i)
            && !RunRow.LEFT_OUT.contains(name)
            && (all || name.startsWith("var_"))) {
          places.add(i);
        }
      }
      return places;
    }

    void grow() {
      int now = rows.map(RunRows::size).orElse(0);
      if (now > size) {
        int first = size;
        size = now;
        fireTableRowsInserted(first, now - 1);
      }
    }

    RunRow row(int place) {
      return rows.orElseThrow().get(place);
    }

    ResultColumn column(int column) {
      return rows.orElseThrow().columns().get(shown.get(column));
    }

    boolean text(int column) {
      return column(column).type() == CellType.TEXT;
    }

    @Override
    public int getRowCount() {
      return size;
    }

    @Override
    public int getColumnCount() {
      return shown.size();
    }

    @Override
    public String getColumnName(int column) {
      ResultColumn of = column(column);
      return of.unit().isEmpty() ? of.name() : of.name() + ", " + of.unit();
    }

    @Override
    public Class<?> getColumnClass(int column) {
      return text(column) ? String.class : Double.class;
    }

    /** Where there is no number, sorting needs one all the same: it comes last. */
    @Override
    public Object getValueAt(int row, int column) {
      int place = shown.get(column);
      return text(column) ? row(row).text(place) : (Object) row(row).number(place);
    }
  }

  /** A cell: numbers in few digits, and what did not end well in another colour. */
  private final class Cell extends DefaultTableCellRenderer {
    @Override
    public Component getTableCellRendererComponent(
        JTable table, Object value, boolean selected, boolean focused, int row, int column) {
      boolean number = value instanceof Double;
      ResultColumn of = model.column(convertColumnIndexToModel(column));
      boolean outcome = of.name().equals("outcome");
      Optional<String> node = number ? node(of, (Double) value) : Optional.empty();
      super.getTableCellRendererComponent(
          table,
          number
              ? node.orElseGet(() -> SweepWords.brief((Double) value))
              : outcome ? SweepWords.outcome(String.valueOf(value)) : value,
          selected,
          focused,
          row,
          column);
      setHorizontalAlignment(
          number && node.isEmpty() ? SwingConstants.TRAILING : SwingConstants.LEADING);
      if (!selected) {
        setForeground(
            outcome
                ? SweepWords.color(RunOutcome.of(String.valueOf(value)))
                : table.getForeground());
      }
      return this;
    }
  }
}
