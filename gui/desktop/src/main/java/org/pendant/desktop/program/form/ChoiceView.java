package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import javax.swing.DefaultComboBoxModel;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JList;
import org.pendant.desktop.program.form.Item.Option;
import org.pendant.kit.theme.Palette;

/** Choice view: a choice that folds out; says when what was chosen is no longer there. */
final class ChoiceView implements FieldView {
  private final JComboBox<Option> box = new JComboBox<>();
  private final FieldPanel panel;
  private Item.Choice item;
  private List<Option> options = List.of();
  private boolean showing;

  ChoiceView(FieldViews views, Item.Choice choice) {
    item = choice;
    box.setRenderer(new Cell());
    box.setPrototypeDisplayValue(new Option("", "digital_out[0]"));
    views.named(box, choice);
    box.addActionListener(
        event -> {
          if (!showing && box.getSelectedItem() instanceof Option chosen) {
            views.presenter().choose(item.name(), chosen.value());
            views.done().run();
          }
        });
    panel = new FieldPanel(box, box.getName(), () -> "");
    show(choice);
  }

  /** Texts of options; what is not there in another colour. */
  @SuppressWarnings("serial") // never written to a stream
  private final class Cell extends DefaultListCellRenderer {
    @Override
    public Component getListCellRendererComponent(
        JList<?> list, Object value, int index, boolean selected, boolean focused) {
      String text = value instanceof Option option ? option.text() : "\u2014";
      super.getListCellRendererComponent(list, text, index, selected, focused);
      if (value instanceof Option option && !selected && !item.options().contains(option)) {
        setForeground(Palette.error());
      }
      return this;
    }
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public JComponent focus() {
    return box;
  }

  @Override
  public void show(Item shown) {
    item = (Item.Choice) shown;
    showing = true;
    List<Option> wanted = new ArrayList<>(item.options());
    String missing = item.problem();
    if (!missing.isEmpty()) {
      wanted.add(0, new Option(item.value(), text("missing", name(item.value()))));
    }
    if (!wanted.equals(options)) {
      options = List.copyOf(wanted);
      box.setModel(new DefaultComboBoxModel<>(options.toArray(new Option[0])));
    }
    box.setSelectedItem(
        options.stream()
            .filter(each -> each.value().equals(item.value()))
            .findFirst()
            .orElse(null));
    showing = false;
    setProblem("");
  }

  /** Without what tells kinds of values apart. */
  private static String name(String value) {
    return value.startsWith("tcp:") ? value.substring(4) : value;
  }

  @Override
  public void setProblem(String problem) {
    String missing =
        item.problem().isEmpty() ? "" : text("quoted", name(item.value()), item.missing());
    String said = panel.say(missing.isEmpty() ? problem : missing);
    box.putClientProperty("JComponent.outline", said.isEmpty() ? null : "error");
    String text = box.getSelectedItem() instanceof Option option ? option.text() : "";
    // a narrow form has no room for all of it
    FieldViews.describe(
        box, said.isEmpty() || text.isEmpty() ? said : text + " \u2013 " + said, text);
  }
}
