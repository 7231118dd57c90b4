package org.pendant.desktop.program.form;

import java.awt.KeyboardFocusManager;
import javax.swing.JComponent;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;

/** Plain text view: lines of a file that can only be read and copied. */
final class PlainView implements FieldView {
  private static final int MIN_ROWS = 4;
  private static final int MAX_ROWS = 20;

  private final JTextArea area = new JTextArea(MIN_ROWS, 12);
  private final JScrollPane scroll = new JScrollPane(area);

  PlainView(FieldViews views, Item.Code code) {
    area.setEditable(false);
    area.putClientProperty("FlatLaf.styleClass", "monospaced");
    area.setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
    area.setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
    views.named(area, code);
    show(code);
  }

  @Override
  public JComponent component() {
    return scroll;
  }

  @Override
  public JComponent focus() {
    return area;
  }

  @Override
  public void show(Item shown) {
    String value = ((Item.Code) shown).value();
    if (!area.getText().equals(value)) {
      area.setText(value);
      area.setCaretPosition(0);
      area.setRows(Math.clamp(value.lines().count(), MIN_ROWS, MAX_ROWS));
    }
  }
}
