package org.pendant.desktop.log;

import javax.swing.table.AbstractTableModel;

/** Log table model: the presenter's rows, for a table. */
@SuppressWarnings("serial") // never written to a stream
final class LogTableModel extends AbstractTableModel {
  private final LogPresenter presenter;

  LogTableModel(LogPresenter presenter) {
    this.presenter = presenter;
  }

  /** Rows went from the top and came at the bottom. */
  void changed(LogPresenter.Change change) {
    if (change.removed() > 0) {
      fireTableRowsDeleted(0, change.removed() - 1);
    }
    if (change.added() > 0) {
      fireTableRowsInserted(getRowCount() - change.added(), getRowCount() - 1);
    }
  }

  @Override
  public int getRowCount() {
    return presenter.rows();
  }

  @Override
  public int getColumnCount() {
    return LogColumn.count();
  }

  @Override
  public String getColumnName(int column) {
    return LogColumn.at(column).title();
  }

  @Override
  public LogLine getValueAt(int row, int column) {
    return presenter.row(row);
  }
}
