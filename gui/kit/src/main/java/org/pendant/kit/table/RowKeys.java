package org.pendant.kit.table;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.JTable;

/**
 * Row keys: where the keyboard begins in a table without a selected row, as it does in lists: Up
 * and Page up at the last row, Down and Page down at the first in sight. Swing begins at the first
 * of all, which may be far away.
 */
public final class RowKeys {
  private RowKeys() {}

  /** Has the keys of a table begin there; they do what they did where a row is selected. */
  public static void install(JTable table) {
    for (String back : new String[] {"selectPreviousRow", "scrollUpChangeSelection"}) {
      begin(table, back, false);
    }
    for (String forward : new String[] {"selectNextRow", "scrollDownChangeSelection"}) {
      begin(table, forward, true);
    }
  }

  private static void begin(JTable table, String name, boolean forward) {
    table.getActionMap().put(name, new Beginning(table, name, forward));
  }

  /** An action of a table, unless no row is selected. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class Beginning extends AbstractAction {
    private final JTable table;
    private final String name;
    private final boolean forward;

    Beginning(JTable table, String name, boolean forward) {
      this.table = table;
      this.name = name;
      this.forward = forward;
    }

    @Override
    public void actionPerformed(ActionEvent event) {
      int rows = table.getRowCount();
      if (rows > 0 && table.getSelectedRow() < 0) {
        int row = forward ? firstInSight() : rows - 1;
        int column =
            Math.max(0, table.getColumnModel().getSelectionModel().getLeadSelectionIndex());
        table.changeSelection(row, column, false, false);
      } else {
        usual().actionPerformed(event);
      }
    }

    /** What the look has for these keys: it may be another one after a change of theme. */
    private Action usual() {
      return table.getActionMap().getParent().get(name);
    }

    /** The first row that is whole in sight, or the one at the top where none is. */
    private int firstInSight() {
      Rectangle sight = table.getVisibleRect();
      int row = Math.max(0, table.rowAtPoint(new Point(0, sight.y)));
      boolean cut = table.getCellRect(row, 0, true).y < sight.y;
      int next = row + 1;
      return cut
              && next < table.getRowCount()
              && sight.contains(0, table.getCellRect(next, 0, true).getMaxY() - 1)
          ? next
          : row;
    }
  }
}
