package org.pendant.desktop.log;

import static org.pendant.desktop.log.LogTexts.text;

import java.awt.Component;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.event.MouseEvent;
import java.util.List;
import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.ListSelectionModel;
import javax.swing.SwingConstants;
import javax.swing.Timer;
import javax.swing.table.TableCellRenderer;
import javax.swing.table.TableColumn;
import org.pendant.kit.fault.Faults;
import org.pendant.kit.table.RowKeys;
import org.pendant.kit.theme.Markup;
import org.pendant.kit.theme.Palette;

/** Log rows: a table whose columns fit its width, and whose rows fit the font and the text. */
@SuppressWarnings("serial") // never written to a stream
final class LogRows extends JTable {
  /** Above and below the text of a row. */
  static final int PADDING = 4;

  /** What the message needs at least, in widths of a digit. */
  private static final int MIN_MESSAGE = 32;

  /** Rows are fitted again when the width has been the same for so long. */
  private static final int SETTLED_MS = 120;

  private final LogPresenter presenter;
  private final LogColumns columns;
  private final MessageCell message;
  private final Timer settled = Faults.timer(SETTLED_MS, this::fitAllRows);
  private Runnable fitted = () -> {};
  private List<LogColumns.Shown> shown = List.of();

  LogRows(LogTableModel model, LogPresenter presenter, LogColumns columns) {
    super();
    this.presenter = presenter;
    this.columns = columns;
    message = new MessageCell(presenter::search);
    settled.setRepeats(false);
    setAutoCreateColumnsFromModel(false);
    setModel(model);
  }

  void prepare() {
    setName("log-table");
    getAccessibleContext().setAccessibleName(text("messagesOfTheLog"));
    setSelectionMode(ListSelectionModel.MULTIPLE_INTERVAL_SELECTION);
    setAutoResizeMode(AUTO_RESIZE_LAST_COLUMN);
    setFillsViewportHeight(true);
    setShowGrid(false);
    getTableHeader().setReorderingAllowed(false);
    RowKeys.install(this);
    getTableHeader().putClientProperty("FlatLaf.style", "cellMargins: 2,8,2,8");
    if (getTableHeader().getDefaultRenderer() instanceof JLabel titles) {
      titles.setHorizontalAlignment(SwingConstants.LEADING);
    }
    fitFont();
  }

  @Override
  public void updateUI() {
    super.updateUI();
    if (columns != null) {
      fitFont();
    }
  }

  @Override
  public Component prepareRenderer(TableCellRenderer renderer, int row, int column) {
    Component cell = super.prepareRenderer(renderer, row, column);
    if (presenter.later(row) && !isRowSelected(row)) {
      cell.setForeground(Palette.tint(Palette.quiet(), 0.55));
    }
    return cell;
  }

  /** Has {@code listener} run when rows have other heights, as the width is another one. */
  void onFitted(Runnable listener) {
    fitted = listener;
  }

  private void fitAllRows() {
    fitRows(0);
    fitted.run();
  }

  private void fitFont() {
    setRowHeight(getFontMetrics(getFont()).getHeight() + 2 * PADDING);
    shown = List.of();
    fitColumns();
  }

  @Override
  public void doLayout() {
    if (getTableHeader() == null || getTableHeader().getResizingColumn() == null) {
      fitColumns();
    } else {
      super.doLayout();
      settled.restart();
    }
  }

  /** Shows the columns that people want, as far as they fit. */
  void fitColumns() {
    FontMetrics metrics = getFontMetrics(getFont());
    List<LogColumns.Shown> wanted =
        columns.fit(
            getWidth(),
            MIN_MESSAGE * metrics.charWidth('0'),
            column ->
                Math.max(metrics.stringWidth(column.widest()), metrics.stringWidth(column.title()))
                    + 24,
            32);
    if (wanted.equals(shown)) {
      return;
    }
    boolean sameColumns = sameColumns(wanted);
    shown = wanted;
    if (!sameColumns) {
      makeColumns();
    }
    for (int i = 0; i < shown.size(); i++) {
      TableColumn column = getColumnModel().getColumn(i);
      column.setPreferredWidth(shown.get(i).width());
      column.setWidth(shown.get(i).width());
    }
    settled.restart();
  }

  private boolean sameColumns(List<LogColumns.Shown> wanted) {
    if (wanted.size() != shown.size() || getColumnCount() != shown.size()) {
      return false;
    }
    for (int i = 0; i < wanted.size(); i++) {
      if (wanted.get(i).column() != shown.get(i).column()
          || wanted.get(i).compact() != shown.get(i).compact()) {
        return false;
      }
    }
    return true;
  }

  private void makeColumns() {
    while (getColumnCount() > 0) {
      removeColumn(getColumnModel().getColumn(0));
    }
    boolean codeBeside = false;
    for (LogColumns.Shown each : shown) {
      codeBeside |= each.column() == LogColumn.CODE;
      TableColumn column = new TableColumn(each.column().index());
      column.setMinWidth(Math.min(24, each.width()));
      column.setHeaderValue(each.compact() ? "" : each.column().title());
      column.setCellRenderer(
          each.column() == LogColumn.MESSAGE
              ? message
              : new LogCell(each.column(), presenter.runs(), each.compact()));
      addColumn(column);
    }
    message.setCodeBeside(codeBeside);
  }

  /** Gives rows, from {@code from} on, the height that their texts need. */
  void fitRows(int from) {
    int index = messageColumn();
    if (index < 0 || getWidth() == 0) {
      return; // done when there is a width
    }
    int width = getColumnModel().getColumn(index).getWidth();
    FontMetrics metrics = getFontMetrics(getFont());
    for (int row = Math.max(0, from); row < getRowCount(); row++) {
      int lines = message.lines(presenter.row(row), metrics, width).size();
      int height = lines * metrics.getHeight() + 2 * PADDING;
      if (getRowHeight(row) != height) {
        setRowHeight(row, height);
      }
    }
  }

  private boolean cut(LogLine line, int column) {
    int width = getColumnModel().getColumn(column).getWidth();
    List<String> lines = message.lines(line, getFontMetrics(getFont()), width);
    return lines.getLast().endsWith("\u2026");
  }

  private int messageColumn() {
    for (int i = 0; i < getColumnCount(); i++) {
      if (LogColumn.at(convertColumnIndexToModel(i)) == LogColumn.MESSAGE) {
        return i;
      }
    }
    return -1;
  }

  @Override
  protected void paintComponent(Graphics g) {
    super.paintComponent(g);
    if (getRowCount() == 0) {
      EmptyNote.paint(this, g, presenter.kept() > 0);
    }
  }

  @Override
  public String getToolTipText(MouseEvent event) {
    int row = rowAtPoint(event.getPoint());
    int column = columnAtPoint(event.getPoint());
    if (row < 0 || column < 0) {
      return null;
    }
    LogLine line = presenter.row(row);
    return switch (LogColumn.at(convertColumnIndexToModel(column))) {
      case LINE ->
          line.sourceLine().isPresent()
              ? text("showPlaceOfTheProgram", presenter.runs().words(line))
              : null;
      case CODE -> CodeHelp.of(line.code()).map(CodeHelp::meaning).orElse(null);
      case SEVERITY -> line.severity();
      case THREAD -> line.thread().isEmpty() ? null : line.thread();
      case MESSAGE -> cut(line, column) ? Markup.toolTip(line.text()) : null;
      case TIME, WALL_TIME, SOURCE -> null;
    };
  }
}
