package org.pendant.kit.theme;

import java.awt.AWTEvent;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.awt.event.ContainerEvent;
import javax.swing.JComponent;

/**
 * Late components: a change of the look reaches what is in a window. What is not, a part that comes
 * and goes, a menu, a panel behind others, takes the look over when it is added. Only the dispatch
 * thread calls it.
 */
final class LateComponents {
  private final AWTEventListener added = this::added;

  /** How often the look has changed; a component that has taken it over has this as a property. */
  private int change;

  /** The look has changed for everything that is in a window. */
  void lookChanged() {
    if (change == 0) {
      // nobody pays for it before
      Toolkit.getDefaultToolkit().addAWTEventListener(added, AWTEvent.CONTAINER_EVENT_MASK);
    }
    change++;
  }

  private void added(AWTEvent event) {
    if (event.getID() == ContainerEvent.COMPONENT_ADDED
        && event instanceof ContainerEvent added
        && added.getChild() instanceof JComponent child
        && !Integer.valueOf(change).equals(child.getClientProperty(this))) {
      child.putClientProperty(this, change);
      LookFollower.update(child);
    }
  }
}
