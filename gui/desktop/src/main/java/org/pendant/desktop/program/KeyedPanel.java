package org.pendant.desktop.program;

import java.awt.event.KeyEvent;
import java.util.function.Predicate;
import javax.swing.JPanel;
import javax.swing.KeyStroke;

/** Keyed panel: keys that mean something in it come before those of the window. */
@SuppressWarnings("serial") // never written to a stream
final class KeyedPanel extends JPanel {
  private final transient Predicate<KeyStroke> keys;

  /**
   * An empty panel; {@code keys} does what a key means in it, and says whether it means anything.
   */
  KeyedPanel(Predicate<KeyStroke> keys) {
    this.keys = keys;
  }

  @Override
  protected boolean processKeyBinding(
      KeyStroke stroke, KeyEvent event, int condition, boolean pressed) {
    return (condition == WHEN_ANCESTOR_OF_FOCUSED_COMPONENT && keys.test(stroke))
        || super.processKeyBinding(stroke, event, condition, pressed);
  }
}
