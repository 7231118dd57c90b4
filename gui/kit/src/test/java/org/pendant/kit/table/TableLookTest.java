package org.pendant.kit.table;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.table.JTableHeader;
import javax.swing.table.TableColumn;
import org.junit.jupiter.api.Test;

final class TableLookTest {
  private final JTable table = new JTable(1, 2);

  @Test
  void aColumnIsAsWideAsItsTitleAtLeast() {
    TableColumn column = table.getColumnModel().getColumn(0);
    column.setHeaderValue("A title that is much longer than most are");
    column.setPreferredWidth(20);
    TableLook.fitTitles(table);
    JTableHeader header = table.getTableHeader();
    int wanted =
        header
            .getFontMetrics(header.getFont())
            .stringWidth("A title that is much longer than most are");
    assertTrue(column.getMinWidth() >= wanted, () -> column.getMinWidth() + " of " + wanted);
    assertTrue(column.getPreferredWidth() >= wanted);
  }

  @Test
  void aColumnThatIsWiderThanItsTitleStaysSo() {
    table.getColumnModel().getColumn(1).setPreferredWidth(500);
    TableLook.fitTitles(table);
    assertEquals(500, table.getColumnModel().getColumn(1).getPreferredWidth());
  }

  @Test
  void aCellThatIsCutTellsAllOfItsText() {
    JLabel cell = new JLabel("digital_in[0], the part is there");
    TableLook.tellingCut(cell, 20);
    assertEquals("digital_in[0], the part is there", cell.getToolTipText());
    TableLook.tellingCut(cell, 2000);
    assertNull(cell.getToolTipText());
  }
}
