package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

import java.util.List;
import java.util.function.Consumer;
import javax.swing.table.AbstractTableModel;
import org.pendant.kit.text.Messages;

/** Memory table model: the rows of a {@link MemoryList} for a table. */
@SuppressWarnings("serial") // never written to a stream
final class MemoryTableModel extends AbstractTableModel {
  static final int NUMBER = 0;
  static final int NAME = 1;
  static final int VALUE = 2;

  private static final List<String> TITLES =
      List.of(text("numberColumn"), text("nameColumn"), text("value"));

  private final transient MemoryList list;
  private final transient Consumer<String> refuse;
  private List<Integer> shown = List.of();

  /** What each row showed last, to tell which have to be painted again. */
  private List<String> texts = List.of();

  /**
   * A table without rows.
   *
   * @param refuse tells why a value was not taken
   */
  MemoryTableModel(MemoryList list, Consumer<String> refuse) {
    this.list = list;
    this.refuse = refuse;
  }

  MemoryList list() {
    return list;
  }

  /** The place that a row shows. */
  int index(int row) {
    return shown.get(row);
  }

  /** Shows what the list has now; answers whether the rows are others than before. */
  boolean refresh() {
    List<String> now =
        list.shown().stream().map(each -> list.text(each) + list.forced(each)).toList();
    if (!shown.equals(list.shown())) {
      shown = list.shown();
      texts = now;
      fireTableDataChanged();
      return true;
    }
    for (int row = 0; row < now.size(); row++) {
      if (!now.get(row).equals(texts.get(row))) {
        fireTableRowsUpdated(row, row);
      }
    }
    texts = now;
    return false;
  }

  @Override
  public int getRowCount() {
    return shown.size();
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
    int index = index(row);
    return switch (column) {
      case NUMBER -> Integer.toString(index);
      case NAME -> list.label(index);
      default -> list.text(index);
    };
  }

  @Override
  public boolean isCellEditable(int row, int column) {
    return column == NAME || (column == VALUE && !list.memory().levels() && list.settable());
  }

  @Override
  public void setValueAt(Object value, int row, int column) {
    if (column == NAME) {
      list.name(index(row), value.toString());
    } else {
      try {
        list.set(index(row), value.toString());
      } catch (IllegalArgumentException e) {
        refuse.accept(Messages.shown(e.getMessage()));
      }
    }
  }
}
