package org.pendant.desktop.ports;

import java.util.List;
import java.util.Locale;
import javax.swing.table.AbstractTableModel;
import org.pendant.protocols.trace.WireMessage;
import org.pendant.protocols.wire.Direction;

/** Message table: messages of clients as rows, the oldest first. */
@SuppressWarnings("serial") // never written to a stream
final class MessageTable extends AbstractTableModel {
  private static final List<String> TITLES =
      List.of("Time", "", "Client", "Port", "Type", "Message");

  private transient List<WireMessage> rows = List.of();

  /** Shows other rows; answers whether there are other ones. */
  boolean show(List<WireMessage> now) {
    if (rows.equals(now)) {
      return false;
    }
    rows = now;
    fireTableDataChanged();
    return true;
  }

  WireMessage row(int row) {
    return rows.get(row);
  }

  /** The row of the message with this number; -1 if it is not shown. */
  int rowOf(long number) {
    int from = 0;
    int to = rows.size();
    while (from < to) {
      int middle = (from + to) / 2;
      if (rows.get(middle).number() < number) {
        from = middle + 1;
      } else {
        to = middle;
      }
    }
    return from < rows.size() && rows.get(from).number() == number ? from : -1;
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
    WireMessage shown = rows.get(row);
    return switch (column) {
      case 0 -> String.format(Locale.ROOT, "%.3f s", shown.robotTimeS());
      case 1 -> shown.direction() == Direction.IN ? "\u2192" : "\u2190";
      case 2 -> shown.peers().client();
      case 3 -> shown.peers().port();
      case 4 -> shown.reading().type();
      default -> shown.reading().effect().orElse(shown.reading().summary());
    };
  }
}
