package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

import java.awt.Component;
import javax.swing.JTable;
import javax.swing.SwingConstants;
import javax.swing.table.DefaultTableCellRenderer;
import org.pendant.kit.theme.Palette;

/** Memory cell: draws the cells of a {@link MemoryTable}. */
@SuppressWarnings("serial") // never written to a stream
final class MemoryCell extends DefaultTableCellRenderer {
  @Override
  public Component getTableCellRendererComponent(
      JTable table, Object value, boolean selected, boolean focused, int row, int column) {
    // a colour that was set for the last cell would stay
    setForeground(null);
    super.getTableCellRendererComponent(table, value, selected, focused, row, column);
    MemoryTableModel model = (MemoryTableModel) table.getModel();
    MemoryList list = model.list();
    int index = model.index(row);
    String name = list.memory().name(index);
    String held = text("holds", name, list.text(index));
    setIcon(null);
    setHorizontalAlignment(SwingConstants.LEADING);
    setHorizontalTextPosition(SwingConstants.LEADING);
    String label = list.label(index).isEmpty() ? "" : list.label(index) + ": ";
    setToolTipText(label + text("heldInScripts", held, list.memory().inScript(index)));
    switch (column) {
      case MemoryTableModel.NUMBER -> setIcon(ForcedMark.of(list.forced(index)));
      case MemoryTableModel.VALUE -> showValue(list, index);
      default -> showName(list, index, selected);
    }
    getAccessibleContext().setAccessibleName(held);
    return this;
  }

  private void showName(MemoryList list, int index, boolean selected) {
    if (list.label(index).isEmpty()) {
      setText("\u2013");
      if (!selected) {
        setForeground(Palette.quiet());
      }
    }
  }

  private void showValue(MemoryList list, int index) {
    setHorizontalAlignment(SwingConstants.TRAILING);
    if (list.memory().levels()) {
      setText("");
      setIcon((list.settable() ? LevelIcon.SWITCH : LevelIcon.LAMP).of(list.value(index) != 0));
    } else {
      setText(list.brief(index));
    }
  }
}
