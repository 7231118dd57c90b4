package org.pendant.kit.find;

import static org.pendant.kit.find.FindTexts.text;

import java.util.List;
import java.util.Locale;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.action.KeyText;
import org.pendant.kit.table.RowsModel;

/** Actions and their keys as a table. */
@SuppressWarnings("serial") // never written to a stream
final class KeyTable extends RowsModel<Action> {
  private static final List<String> COLUMNS = List.of(text("action"), text("key"), "");

  private final transient ActionTable actions;

  KeyTable(ActionTable actions) {
    super(COLUMNS);
    this.actions = actions;
  }

  /** Shows those whose title or key contains {@code text}. */
  void filter(String text) {
    String wanted = text.strip().toLowerCase(Locale.ROOT);
    replace(
        actions.all().stream()
            .filter(
                each ->
                    each.title().toLowerCase(Locale.ROOT).contains(wanted)
                        || KeyText.shown(actions.keysOf(each.id()))
                            .toLowerCase(Locale.ROOT)
                            .contains(wanted))
            .toList());
  }

  @Override
  protected Object cell(Action action, int column) {
    String keys = actions.keysOf(action.id());
    return switch (column) {
      case 0 -> action.title();
      case 1 -> KeyText.shown(keys);
      default ->
          !actions.conflicts(action.id(), keys).isEmpty()
              ? text("conflict")
              : actions.rebound(action.id()) ? text("changed") : "";
    };
  }
}
