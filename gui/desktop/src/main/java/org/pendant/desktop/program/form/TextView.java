package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import org.pendant.kit.icon.Glyph;
import org.pendant.kit.layout.TitledCard;

/** Text view: a line of text, with texts to choose from behind an arrow where there are any. */
final class TextView implements FieldView {
  private static final int COLUMNS = 12;
  private static final int MOST = 20;

  private final TypedField field;
  private final FieldPanel panel;
  private final JButton more = new JButton(Glyph.UNFOLD.icon(11));
  private Item.Text item;

  TextView(FieldViews views, Item.Text text) {
    item = text;
    field =
        new TypedField(
            COLUMNS,
            typed -> views.presenter().typeText(item.name(), typed),
            String::strip,
            views.refused());
    views.named(field, text);
    TitledCard.named(more, field.getName() + "-more", text("chooseOneThatThereIsDown"));
    more.setFocusable(false);
    more.addActionListener(event -> choose());
    field.addKeyListener(
        new KeyAdapter() {
          @Override
          public void keyPressed(KeyEvent event) {
            if (event.getKeyCode() == KeyEvent.VK_DOWN && !item.suggestions().isEmpty()) {
              choose();
              event.consume();
            }
          }
        });
    panel = new FieldPanel(field, field.getName(), field::refusal);
    show(text);
  }

  private void choose() {
    JPopupMenu menu = new JPopupMenu();
    item.suggestions().stream()
        .limit(MOST)
        .forEach(
            each -> {
              JMenuItem entry = new JMenuItem(each);
              entry.addActionListener(event -> field.setText(each));
              menu.add(entry);
            });
    menu.show(field, 0, field.getHeight());
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public JComponent focus() {
    return field;
  }

  @Override
  public void show(Item shown) {
    item = (Item.Text) shown;
    field.follow(item.value());
    field.putClientProperty("JTextField.placeholderText", item.hint());
    field.putClientProperty(
        "JTextField.trailingComponent", item.suggestions().isEmpty() ? null : more);
    setProblem("");
  }

  @Override
  public void setProblem(String problem) {
    String said = panel.say(problem);
    field.outline(!said.isEmpty());
    FieldViews.describe(field, said, item.hint());
  }
}
