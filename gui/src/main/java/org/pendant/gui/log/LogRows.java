package org.pendant.gui.log;

import java.awt.Graphics;
import java.awt.event.MouseEvent;
import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.ListSelectionModel;
import javax.swing.SwingConstants;
import javax.swing.table.TableColumn;

/** A table whose columns and rows fit the font. */
@SuppressWarnings("serial") // never written to a stream
final class LogRows extends JTable {
  private final LogPresenter presenter;

  LogRows(LogTableModel model, LogPresenter presenter) {
    super(model);
    this.presenter = presenter;
  }

  void prepare() {
    setName("log-table");
    getAccessibleContext().setAccessibleName("Messages");
    setSelectionMode(ListSelectionModel.MULTIPLE_INTERVAL_SELECTION);
    setAutoResizeMode(AUTO_RESIZE_LAST_COLUMN);
    setFillsViewportHeight(true);
    setShowGrid(false);
    getTableHeader().setReorderingAllowed(false);
    getTableHeader().putClientProperty("FlatLaf.style", "cellMargins: 2,8,2,8");
    if (getTableHeader().getDefaultRenderer() instanceof JLabel titles) {
      titles.setHorizontalAlignment(SwingConstants.LEADING);
    }
    setDefaultRenderer(Object.class, new LogCell(presenter));
    fitFont();
  }

  @Override
  public void updateUI() {
    super.updateUI();
    fitFont();
  }

  private void fitFont() {
    if (getColumnCount() == 0) {
      return;
    }
    setRowHeight(getFontMetrics(getFont()).getHeight() + 8);
    for (int i = 0; i < LogColumn.count(); i++) {
      LogColumn each = LogColumn.at(i);
      TableColumn column = getColumnModel().getColumn(i);
      if (each.widest().isEmpty()) {
        column.setPreferredWidth(2000);
      } else {
        int width = getFontMetrics(getFont()).stringWidth(each.widest()) + 24;
        column.setMinWidth(width);
        column.setPreferredWidth(width);
        column.setMaxWidth(2 * width);
      }
    }
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
    if (row < 0 || LogColumn.at(convertColumnIndexToModel(column)) != LogColumn.LINE) {
      return null;
    }
    LogLine line = presenter.row(row);
    return line.sourceLine().isPresent()
        ? "Show line " + line.sourceLine().getAsInt() + " of the program"
        : null;
  }
}
