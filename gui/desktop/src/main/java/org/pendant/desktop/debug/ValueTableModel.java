package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

import java.util.List;
import java.util.function.BiConsumer;
import org.pendant.kit.table.RowsModel;

/** Value table model: the rows of a {@link ValueTree} as a table: name, value, kind. */
@SuppressWarnings("serial") // never written to a stream
final class ValueTableModel extends RowsModel<ValueRow> {
  static final int NAME = 0;
  static final int VALUE = 1;
  static final int KIND = 2;
  static final int STAR = 3;
  private static final List<String> TITLES =
      List.of(text("nameColumn"), text("valueColumn"), text("kindColumn"), "");

  private final ValueTree tree;
  private final boolean namesEditable;
  private final BiConsumer<ValueRow.Value, String> rename;
  private final boolean stars;

  /**
   * @param namesEditable whether the names of those that are part of nothing can be changed
   * @param rename changes one
   * @param stars whether there is a column for favourites
   */
  ValueTableModel(
      ValueTree tree,
      boolean namesEditable,
      BiConsumer<ValueRow.Value, String> rename,
      boolean stars) {
    super(TITLES);
    this.stars = stars;
    this.tree = tree;
    this.namesEditable = namesEditable;
    this.rename = rename;
  }

  @Override
  public int getColumnCount() {
    return stars ? STAR + 1 : STAR;
  }

  /** What an editor begins with. */
  @Override
  protected Object cell(ValueRow row, int column) {
    return switch (row) {
      case ValueRow.Value value ->
          switch (column) {
            case NAME -> value.name();
            case VALUE -> tree.toEdit(value);
            case KIND -> value.kind();
            default -> value.favourite() ? text("favourite") : "";
          };
      case ValueRow.Heading heading -> heading.title();
      case ValueRow.More more -> more.text();
      case ValueRow.Problem problem -> problem.text();
    };
  }

  @Override
  public boolean isCellEditable(int row, int column) {
    return row(row) instanceof ValueRow.Value value
        && switch (column) {
          case NAME -> namesEditable && value.level() == 0;
          case VALUE -> tree.canAssign(value);
          default -> false;
        };
  }

  @Override
  public void setValueAt(Object typed, int row, int column) {
    if (row < getRowCount() && row(row) instanceof ValueRow.Value value) {
      if (column == NAME) {
        rename.accept(value, typed.toString());
      } else {
        tree.assign(value, typed.toString());
      }
    }
  }
}
