package org.pendant.kit.find;

import java.util.List;
import java.util.Locale;
import javax.swing.table.AbstractTableModel;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.action.KeyText;

/** Actions and their keys as a table. */
@SuppressWarnings("serial") // never written to a stream
final class KeyTable extends AbstractTableModel {
  private static final List<String> COLUMNS = List.of("Action", "Key", "");

  private final transient ActionTable actions;
  private transient List<Action> shown = List.of();

  KeyTable(ActionTable actions) {
    this.actions = actions;
  }

  /** Shows those whose title or key contains {@code text}. */
  void filter(String text) {
    String wanted = text.strip().toLowerCase(Locale.ROOT);
    shown =
        actions.all().stream()
            .filter(
                each ->
                    each.title().toLowerCase(Locale.ROOT).contains(wanted)
                        || KeyText.shown(actions.keysOf(each.id()))
                            .toLowerCase(Locale.ROOT)
                            .contains(wanted))
            .toList();
    fireTableDataChanged();
  }

  Action action(int row) {
    return shown.get(row);
  }

  @Override
  public int getRowCount() {
    return shown.size();
  }

  @Override
  public int getColumnCount() {
    return COLUMNS.size();
  }

  @Override
  public String getColumnName(int column) {
    return COLUMNS.get(column);
  }

  @Override
  public Object getValueAt(int row, int column) {
    Action action = shown.get(row);
    String keys = actions.keysOf(action.id());
    return switch (column) {
      case 0 -> action.title();
      case 1 -> KeyText.shown(keys);
      default ->
          !actions.conflicts(action.id(), keys).isEmpty()
              ? "conflict"
              : actions.rebound(action.id()) ? "changed" : "";
    };
  }
}
