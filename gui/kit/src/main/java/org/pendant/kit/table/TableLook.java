package org.pendant.kit.table;

import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.ListSelectionModel;
import javax.swing.SwingConstants;

/** Table look: what our tables look like and how they are worked with. */
public final class TableLook {
  private TableLook() {}

  /**
   * One row can be selected, by keys from where {@link RowKeys} says; no lines are between cells,
   * titles are at the left and stay in order.
   *
   * @param name of the component
   * @param spoken its name for people who hear it
   */
  public static void apply(JTable table, String name, String spoken) {
    table.setName(name);
    table.getAccessibleContext().setAccessibleName(spoken);
    table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    table.setShowGrid(false);
    table.setFillsViewportHeight(true);
    table.getTableHeader().setReorderingAllowed(false);
    RowKeys.install(table);
    if (table.getTableHeader().getDefaultRenderer() instanceof JLabel title) {
      title.setHorizontalAlignment(SwingConstants.LEADING);
    }
  }

  /** Typing over a cell edits it, and what is typed is taken when the keyboard goes elsewhere. */
  public static void editInPlace(JTable table) {
    table.putClientProperty("JTable.autoStartsEdit", true);
    table.putClientProperty("terminateEditOnFocusLost", true);
    table.setSurrendersFocusOnKeystroke(true);
  }

  /** Rows are as high as the font, and {@code space} pixels more. */
  public static void fitRows(JTable table, int space) {
    table.setRowHeight(table.getFontMetrics(table.getFont()).getHeight() + space);
  }
}
