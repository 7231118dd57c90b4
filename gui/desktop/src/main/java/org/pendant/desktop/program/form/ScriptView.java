package org.pendant.desktop.program.form;

import javax.swing.JComponent;
import org.pendant.desktop.editor.ScriptPad;

/** Script view: URScript with its colours. */
final class ScriptView implements FieldView {
  private static final int MIN_ROWS = 3;
  private static final int MAX_ROWS = 16;

  private final ScriptPad pad;
  private final FieldPanel panel;
  private Item.Code item;

  ScriptView(FieldViews views, Item.Code code) {
    item = code;
    pad =
        new ScriptPad(
            views.catalogue(),
            code.edit().isPresent(),
            text -> {
              var _ = views.presenter().typeText(item.name(), text);
            });
    views.named(pad.text(), code);
    panel = new FieldPanel(pad, pad.text().getName(), () -> "");
    show(code);
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public JComponent focus() {
    return pad.text();
  }

  @Override
  public void show(Item shown) {
    item = (Item.Code) shown;
    pad.show(item.value());
    int lines = (int) item.value().lines().count() + 1;
    pad.setRows(Math.clamp(lines, MIN_ROWS, MAX_ROWS));
  }

  @Override
  public void setProblem(String problem) {
    FieldViews.describe(pad.text(), panel.say(problem), "");
  }
}
