package org.pendant.kit.table;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.EventQueue;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import javax.swing.JTable;
import javax.swing.JViewport;
import org.junit.jupiter.api.Test;

/** A table of 50 rows, of which five and a half are in sight, from the middle of the tenth. */
final class RowKeysTest {
  private static final int ROW = 20;

  private final JTable table = new JTable(50, 2);

  private int selectedAfter(int before, String key) throws Exception {
    EventQueue.invokeAndWait(
        () -> {
          table.setRowHeight(ROW);
          table.setSize(200, 50 * ROW);
          JViewport sight = new JViewport();
          sight.setView(table);
          sight.setSize(200, 5 * ROW + ROW / 2);
          sight.setViewPosition(new Rectangle(0, 9 * ROW + ROW / 2, 1, 1).getLocation());
          RowKeys.install(table);
          if (before >= 0) {
            table.changeSelection(before, 1, false, false);
          }
          table
              .getActionMap()
              .get(key)
              .actionPerformed(new ActionEvent(table, ActionEvent.ACTION_PERFORMED, key));
        });
    return table.getSelectedRow();
  }

  @Test
  void upBeginsAtTheLastRow() throws Exception {
    assertEquals(49, selectedAfter(-1, "selectPreviousRow"));
  }

  @Test
  void downBeginsAtTheFirstRowThatIsWholeInSight() throws Exception {
    assertEquals(10, selectedAfter(-1, "selectNextRow"));
  }

  @Test
  void fromASelectedRowTheyGoToItsNeighbours() throws Exception {
    assertEquals(29, selectedAfter(30, "selectPreviousRow"));
    assertEquals(21, selectedAfter(20, "selectNextRow"));
  }
}
