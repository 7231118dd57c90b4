package org.pendant.desktop.program.form;

import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.util.EnumSet;
import java.util.Set;
import javax.swing.JTextField;

/**
 * Field keys: Enter tidies what is in a field, Escape brings back what was there when it got the
 * focus.
 */
final class FieldKeys extends KeyAdapter {
  /** How the focus comes by Tab: what is typed then takes the place of what is there. */
  private static final Set<FocusEvent.Cause> BY_KEY =
      EnumSet.of(FocusEvent.Cause.TRAVERSAL_FORWARD, FocusEvent.Cause.TRAVERSAL_BACKWARD);

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
    field.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusGained(FocusEvent event) {
            if (!event.isTemporary()) {
              keys.before = field.getText();
              if (BY_KEY.contains(event.getCause())) {
                field.selectAll();
              }
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
