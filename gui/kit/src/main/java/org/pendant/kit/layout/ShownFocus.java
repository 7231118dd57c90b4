package org.pendant.kit.layout;

import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import javax.swing.JComponent;

/** Shown focus: scrolls what is around a component to where it is seen when keys come to it. */
public final class ShownFocus {
  private ShownFocus() {}

  /** Has keys bring {@code component} into sight. */
  public static <C extends JComponent> C of(C component) {
    return of(component, component);
  }

  /**
   * Has keys that come to a component bring another one into sight.
   *
   * @param whole what is to be seen, such as the scroll pane around it
   */
  public static <C extends JComponent> C of(C component, JComponent whole) {
    component.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusGained(FocusEvent event) {
            // a text field would scroll its own text
            if (whole.getParent() instanceof JComponent around) {
              around.scrollRectToVisible(whole.getBounds());
            }
          }
        });
    return component;
  }
}
