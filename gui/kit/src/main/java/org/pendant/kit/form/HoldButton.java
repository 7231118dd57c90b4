package org.pendant.kit.form;

import javax.swing.Icon;
import javax.swing.JButton;

/** A button that does something as long as mouse, finger or space bar holds it. */
@SuppressWarnings("serial") // never written to a stream
public final class HoldButton extends JButton {
  private boolean held;

  /**
   * A button.
   *
   * @param press runs when it is pressed
   * @param release runs when it is let go, is disabled, or loses the pointer or the focus
   */
  public HoldButton(String text, Icon icon, Runnable press, Runnable release) {
    super(text, icon);
    addChangeListener(
        event -> {
          boolean now = getModel().isPressed() && getModel().isArmed();
          if (now != held) {
            held = now;
            (now ? press : release).run();
          }
        });
  }
}
