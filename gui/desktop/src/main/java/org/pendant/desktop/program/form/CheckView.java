package org.pendant.desktop.program.form;

import javax.swing.JCheckBox;
import javax.swing.JComponent;

/** Check view: yes or no. */
final class CheckView implements FieldView {
  private final JCheckBox box;
  private final FieldPanel panel;
  private Item.Check item;

  CheckView(FieldViews views, Item.Check check) {
    item = check;
    box = new JCheckBox(check.label());
    box.setOpaque(false);
    views.named(box, check);
    box.setToolTipText(check.label());
    box.addActionListener(
        event -> {
          views.presenter().check(item.name(), box.isSelected());
          views.done().run();
        });
    panel = new FieldPanel(box, box.getName(), () -> "");
    show(check);
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
    item = (Item.Check) shown;
    box.setSelected(item.value());
    setProblem("");
  }

  @Override
  public void setProblem(String problem) {
    panel.say(problem);
  }
}
