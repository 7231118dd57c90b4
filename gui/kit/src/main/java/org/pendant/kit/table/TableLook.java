package org.pendant.kit.table;

import java.awt.Component;
import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.ListSelectionModel;
import javax.swing.SwingConstants;
import javax.swing.table.JTableHeader;
import javax.swing.table.TableColumn;

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

  /**
   * No column is narrower than its title, in whatever language it is.
   *
   * @param table whose columns have their widths and titles
   */
  public static void fitTitles(JTable table) {
    JTableHeader header = table.getTableHeader();
    for (int i = 0; i < table.getColumnCount(); i++) {
      TableColumn column = table.getColumnModel().getColumn(i);
      int width =
          header
              .getDefaultRenderer()
              .getTableCellRendererComponent(table, column.getHeaderValue(), false, false, -1, i)
              .getPreferredSize()
              .width;
      column.setMinWidth(Math.max(column.getMinWidth(), width));
      column.setPreferredWidth(Math.max(column.getPreferredWidth(), width));
    }
  }

  /**
   * A cell with all of its text as its tool tip if the column is too narrow for it.
   *
   * @param cell as it is drawn
   * @param width of the column, in pixels
   */
  public static Component tellingCut(Component cell, int width) {
    if (cell instanceof JLabel label) {
      label.setToolTipText(label.getPreferredSize().width > width ? label.getText() : null);
    }
    return cell;
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
