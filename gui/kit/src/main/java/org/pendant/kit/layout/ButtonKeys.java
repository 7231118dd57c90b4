package org.pendant.kit.layout;

import java.awt.EventQueue;
import java.awt.event.MouseEvent;
import javax.swing.AbstractButton;

/** Button keys: where keys go when the button that has them is used up. */
public final class ButtonKeys {
  private ButtonKeys() {}

  /**
   * Enables a button or not. Keys of one that is disabled would go to the button beside it, which a
   * space then presses.
   *
   * @param giveKeys gives them to something else
   */
  public static void enable(AbstractButton button, boolean enabled, Runnable giveKeys) {
    boolean has = button.isFocusOwner();
    button.setEnabled(enabled);
    if (enabled) {
      return;
    }
    if (has) {
      giveKeys.run();
    } else if (isClicked(button)) {
      // the keys that the click brings are still on their way
      EventQueue.invokeLater(giveKeys);
    }
  }

  private static boolean isClicked(AbstractButton button) {
    return EventQueue.getCurrentEvent() instanceof MouseEvent click
        && button.equals(click.getSource());
  }
}
