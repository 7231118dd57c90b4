package org.pendant.desktop.ports;

import static org.junit.jupiter.api.Assertions.assertEquals;

import javax.swing.JLabel;
import javax.swing.JTable;
import org.junit.jupiter.api.Test;
import org.pendant.kit.dispatch.OnDispatchThread;

@OnDispatchThread
final class RateCellRendererTest {
  private static final String RATE = "126/s, 23.2 kB/s";

  private final JTable table = new JTable(1, 1);

  private String shown(int width) {
    table.getColumnModel().getColumn(0).setMinWidth(0);
    table.getColumnModel().getColumn(0).setWidth(width);
    return ((JLabel)
            new RateCellRenderer().getTableCellRendererComponent(table, RATE, false, false, 0, 0))
        .getText();
  }

  @Test
  void aNarrowColumnHasTheBytesAlone() {
    assertEquals("23.2 kB/s", shown(20));
  }

  @Test
  void aWideOneHasMessagesAndBytes() {
    assertEquals(RATE, shown(900));
  }
}
