package org.pendant.desktop.program.form;

import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import javax.swing.JTextField;
import org.pendant.kit.form.TabSelection;

/**
 * Field keys: Enter tidies what is in a field, Escape brings back what was there when it got the
 * focus.
 */
final class FieldKeys extends KeyAdapter {
  private final JTextField field;
  private final Runnable commit;
  private String before = "";

  /**
   * Listens to a field from now on.
   *
   * @param commit runs at Enter, and when the focus goes
   */
  static void listen(JTextField field, Runnable commit) {
    FieldKeys keys = new FieldKeys(field, commit);
    field.addKeyListener(keys);
    TabSelection.of(field);
    field.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusGained(FocusEvent event) {
            if (!event.isTemporary()) {
              keys.before = field.getText();
            }
          }

          @Override
          public void focusLost(FocusEvent event) {
            if (!event.isTemporary()) {
              commit.run();
            }
          }
        });
  }

  private FieldKeys(JTextField field, Runnable commit) {
    this.field = field;
    this.commit = commit;
  }

  @Override
  public void keyPressed(KeyEvent event) {
    if (event.isConsumed() || event.getModifiersEx() != 0) {
      return;
    }
    if (event.getKeyCode() == KeyEvent.VK_ENTER) {
      commit.run();
      before = field.getText();
      field.selectAll();
      event.consume();
    } else if (event.getKeyCode() == KeyEvent.VK_ESCAPE && !field.getText().equals(before)) {
      field.setText(before);
      field.selectAll();
      event.consume();
    }
  }
}
