package org.pendant.desktop.ports;

import java.util.List;
import javax.swing.table.AbstractTableModel;
import org.pendant.desktop.ports.PortsPresenter.Row;

/** Port table: the open ports as rows. */
@SuppressWarnings("serial") // never written to a stream
final class PortTable extends AbstractTableModel {
  private static final List<String> TITLES = List.of("Port", "Address", "Clients");

  private transient List<Row> rows = List.of();

  /** Shows other rows; the selection stays where only numbers have changed. */
  void show(List<Row> now) {
    if (now.equals(rows)) {
      return;
    }
    boolean same = now.size() == rows.size();
    rows = now;
    if (same && !now.isEmpty()) {
      fireTableRowsUpdated(0, now.size() - 1);
    } else {
      fireTableDataChanged();
    }
  }

  /** Who is connected there; empty for no client. */
  String who(int row) {
    return rows.get(row).who();
  }

  @Override
  public int getRowCount() {
    return rows.size();
  }

  @Override
  public int getColumnCount() {
    return TITLES.size();
  }

  @Override
  public String getColumnName(int column) {
    return TITLES.get(column);
  }

  @Override
  public Object getValueAt(int row, int column) {
    Row shown = rows.get(row);
    return switch (column) {
      case 0 -> shown.name();
      case 1 -> shown.address();
      default -> shown.clients() == 0 ? "" : Integer.toString(shown.clients());
    };
  }
}
