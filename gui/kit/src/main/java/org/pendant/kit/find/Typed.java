package org.pendant.kit.find;

import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;

/** Does something after each change of a text field. */
record Typed(Runnable then) implements DocumentListener {
  @Override
  public void insertUpdate(DocumentEvent event) {
    then.run();
  }

  @Override
  public void removeUpdate(DocumentEvent event) {
    then.run();
  }

  @Override
  public void changedUpdate(DocumentEvent event) {}
}
