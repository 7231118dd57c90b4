package org.pendant.desktop.program.form;

import java.util.LinkedHashMap;
import java.util.Map;
import javax.swing.ButtonGroup;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import org.pendant.desktop.program.form.Item.Option;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.text.Messages;

/** Segmented view: a choice of few, as buttons beside each other. */
final class SidesView implements FieldView {
  private final JPanel row = new JPanel(new WrappingRow(PressesView.GAP));
  private final Map<String, JToggleButton> buttons = new LinkedHashMap<>();
  private final FieldPanel panel;
  private Item.Choice item;

  SidesView(FieldViews views, Item.Choice choice) {
    item = choice;
    PressesView.bare(row);
    views.named(row, choice);
    ButtonGroup group = new ButtonGroup();
    for (Option each : choice.options()) {
      JToggleButton button = new JToggleButton(each.text());
      button.putClientProperty("FlatLaf.style", "minimumWidth: 0; margin: 2,8,2,8");
      TitledCard.named(button, row.getName() + "-" + each.value(), words(choice, each));
      button.addActionListener(
          event -> {
            views.presenter().choose(item.name(), each.value());
            views.done().run();
          });
      group.add(button);
      buttons.put(each.value(), button);
      row.add(button);
    }
    panel = new FieldPanel(row, row.getName(), () -> "");
    show(choice);
  }

  private static String words(Item.Choice choice, Option option) {
    return choice.label().isEmpty() ? option.text() : Messages.told(choice.label(), option.text());
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public JComponent focus() {
    return buttons.values().stream()
        .filter(JToggleButton::isSelected)
        .findFirst()
        .orElseGet(() -> buttons.values().iterator().next());
  }

  @Override
  public void show(Item shown) {
    item = (Item.Choice) shown;
    JToggleButton chosen = buttons.get(item.value());
    if (chosen != null) {
      chosen.setSelected(true);
    }
    setProblem("");
  }

  @Override
  public void setProblem(String problem) {
    panel.say(problem);
  }
}
