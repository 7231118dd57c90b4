package org.pendant.kit.table;

import java.util.List;
import javax.swing.table.AbstractTableModel;

/**
 * Rows model: a list as the rows of a table whose columns have titles. One thread uses it, the
 * dispatch thread.
 *
 * @param <R> what a row shows
 */
@SuppressWarnings("serial") // never written to a stream
public abstract class RowsModel<R> extends AbstractTableModel {
  private final transient List<String> titles;
  private transient List<R> rows = List.of();

  /** Without rows. */
  protected RowsModel(List<String> titles) {
    this.titles = List.copyOf(titles);
  }

  /** What a cell of a row shows. */
  protected abstract Object cell(R row, int column);

  /**
   * Shows other rows. Where there are as many as before, only those that differ are painted, and
   * what is selected or edited stays.
   *
   * @return whether it is another number of rows
   */
  public boolean show(List<? extends R> wanted) {
    List<R> before = rows;
    rows = List.copyOf(wanted);
    if (before.size() != rows.size()) {
      fireTableDataChanged();
      return true;
    }
    for (int i = 0; i < rows.size(); i++) {
      if (!rows.get(i).equals(before.get(i))) {
        fireTableRowsUpdated(i, i);
      }
    }
    return false;
  }

  /**
   * Shows the rows of something else: nothing is selected from then on, unless they are the same.
   *
   * @return whether they are others
   */
  public boolean replace(List<? extends R> wanted) {
    if (wanted.equals(rows)) {
      return false;
    }
    rows = List.copyOf(wanted);
    fireTableDataChanged();
    return true;
  }

  /** All rows, from the top. */
  public final List<R> rows() {
    return rows;
  }

  /** What a row shows. */
  public final R row(int row) {
    return rows.get(row);
  }

  @Override
  public final int getRowCount() {
    return rows.size();
  }

  @Override
  public int getColumnCount() {
    return titles.size();
  }

  @Override
  public final String getColumnName(int column) {
    return titles.get(column);
  }

  @Override
  public Object getValueAt(int row, int column) {
    return cell(row(row), column);
  }
}
