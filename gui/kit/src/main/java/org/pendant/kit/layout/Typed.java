package org.pendant.kit.layout;

import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;

/**
 * Typing listener: hears of every change of a text field.
 *
 * @param changed runs after each
 */
public record Typed(Runnable changed) implements DocumentListener {
  @Override
  public void insertUpdate(DocumentEvent event) {
    changed.run();
  }

  @Override
  public void removeUpdate(DocumentEvent event) {
    changed.run();
  }

  @Override
  public void changedUpdate(DocumentEvent event) {
    // styles, which fields do not have
  }
}
