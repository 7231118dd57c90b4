package org.pendant.desktop.move;

import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.ButtonGroup;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.layout.TitledCard;

/** Segmented choice of one of a few, as buttons side by side. */
final class Segments<E extends Enum<E>> {
  private final JPanel row = new JPanel(new MigLayout("insets 0, gap 0", ""));
  private final Map<E, JToggleButton> buttons;

  /**
   * Buttons for all values of an enum.
   *
   * @param prefix of the buttons' names
   * @param title what a button says
   * @param tip what it does
   */
  Segments(
      Class<E> type,
      E chosen,
      String prefix,
      Function<E, String> title,
      Function<E, String> tip,
      Consumer<E> choose) {
    row.setOpaque(false);
    buttons = new EnumMap<>(type);
    ButtonGroup group = new ButtonGroup();
    for (E each : type.getEnumConstants()) {
      JToggleButton button = new JToggleButton(title.apply(each), each == chosen);
      button.putClientProperty("FlatLaf.style", "minimumWidth: 0; margin: 2,8,2,8");
      TitledCard.named(
          button, prefix + each.name().toLowerCase(Locale.ROOT).replace('_', '-'), tip.apply(each));
      button.addActionListener(event -> choose.accept(each));
      group.add(button);
      buttons.put(each, button);
      row.add(button);
    }
  }

  JComponent component() {
    return row;
  }

  /** Says something else on the buttons from now on, and in their tips. */
  void write(Function<E, String> title, Function<E, String> tip) {
    buttons.forEach(
        (each, button) -> {
          button.setText(title.apply(each));
          TitledCard.named(button, button.getName(), tip.apply(each));
        });
  }

  /** Shows what is chosen by other means. */
  void show(E chosen) {
    buttons.get(chosen).setSelected(true);
  }
}
