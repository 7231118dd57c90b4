package org.pendant.kit.find;

import static org.pendant.kit.find.FindTexts.text;

import java.awt.Color;
import java.awt.Component;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.ListCellRenderer;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.action.KeyText;
import org.pendant.kit.theme.Palette;

/**
 * Palette row: title, reason and key of an action in one row; a component, so that it follows the
 * look.
 */
@SuppressWarnings("serial") // never written to a stream
final class PaletteRow extends JPanel implements ListCellRenderer<Action> {
  private final ActionTable actions;
  private final JLabel title = new JLabel();
  private final JLabel reason = new JLabel();
  private final JLabel keys = new JLabel();

  PaletteRow(ActionTable actions) {
    super(
        new MigLayout(
            "insets 4 8 4 8", "[0:pref:, shrinkprio 100]8[grow, 0::, shrinkprio 200]16[right]"));
    this.actions = actions;
    add(title, "wmin 0");
    add(reason, "wmin 0"); // the first to give way
    add(keys, "wmin pref");
  }

  /** What is on, and which of several is chosen. */
  private static String word(Action.Mark mark) {
    return switch (mark) {
      case Action.Mark.Check(var on) -> on.getAsBoolean() ? text("on") : text("off");
      case Action.Mark.Choice(var on) -> on.getAsBoolean() ? text("chosen") : "";
    };
  }

  @Override
  public Component getListCellRendererComponent(
      JList<? extends Action> all, Action action, int index, boolean selected, boolean focus) {
    boolean enabled = action.enabled().getAsBoolean();
    setBackground(selected ? all.getSelectionBackground() : all.getBackground());
    Color words = selected ? all.getSelectionForeground() : all.getForeground();
    title.setText(action.title());
    title.setForeground(enabled ? words : Palette.quiet());
    reason.setText(
        enabled ? action.mark().map(PaletteRow::word).orElse("") : actions.reason(action.id()));
    reason.setForeground(Palette.quiet());
    keys.setText(KeyText.shown(actions.keysOf(action.id())));
    keys.setForeground(selected ? words : Palette.quiet());
    getAccessibleContext().setAccessibleName(action.title());
    return this;
  }
}
