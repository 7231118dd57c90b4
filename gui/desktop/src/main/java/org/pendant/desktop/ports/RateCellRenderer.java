package org.pendant.desktop.ports;

import java.awt.Component;
import javax.swing.JTable;
import javax.swing.table.DefaultTableCellRenderer;

/**
 * Rate cells: {@code 126/s, 23.2 kB/s}, messages and bytes, as far as there is room; where there is
 * none for both, the bytes, and the tip has both.
 */
@SuppressWarnings("serial") // never written to a stream
final class RateCellRenderer extends DefaultTableCellRenderer {
  private static final String BETWEEN = ", ";

  @Override
  public Component getTableCellRendererComponent(
      JTable table, Object value, boolean chosen, boolean focused, int row, int column) {
    super.getTableCellRendererComponent(table, value, chosen, focused, row, column);
    int room = table.getColumnModel().getColumn(column).getWidth();
    int comma = getText().indexOf(BETWEEN);
    if (comma >= 0 && getPreferredSize().width > room) {
      setText(getText().substring(comma + BETWEEN.length()));
    }
    return this;
  }
}
