package org.pendant.desktop.program.form;

import java.awt.KeyboardFocusManager;
import javax.swing.JComponent;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import org.pendant.kit.layout.Typed;

/** Prose view: several lines of text; Tab continues to the next field. */
final class ProseView implements FieldView {
  private static final int ROWS = 4;

  private final JTextArea area = new JTextArea(ROWS, 12);
  private final FieldPanel panel;
  private Item.Prose item;
  private boolean showing;

  ProseView(FieldViews views, Item.Prose prose) {
    item = prose;
    area.setLineWrap(true);
    area.setWrapStyleWord(true);
    area.setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
    area.setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
    views.named(area, prose);
    area.getDocument()
        .addDocumentListener(
            new Typed(
                () -> {
                  if (!showing) {
                    var _ = views.presenter().typeText(item.name(), area.getText());
                  }
                }));
    panel = new FieldPanel(new JScrollPane(area), area.getName(), () -> "");
    show(prose);
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public JComponent focus() {
    return area;
  }

  @Override
  public void show(Item shown) {
    item = (Item.Prose) shown;
    if (!area.getText().equals(item.value())) {
      showing = true;
      int caret = area.getCaretPosition();
      area.setText(item.value());
      area.setCaretPosition(Math.min(caret, item.value().length()));
      showing = false;
    }
    setProblem("");
  }

  @Override
  public void setProblem(String problem) {
    FieldViews.describe(area, panel.say(problem), "");
  }
}
