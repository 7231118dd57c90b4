package org.pendant.kit.theme;

import java.awt.Component;
import java.awt.Container;
import javax.swing.SwingUtilities;

/**
 * Look follower: a component with colours that its look does not set. It takes them over in the
 * event in which the look changes, so that everything in a window changes in one paint.
 */
public interface LookFollower {
  /** The component and all parts of it have the look of now. */
  void lookChanged();

  /** Gives a component, and all in it, the look of now. */
  static void update(Component component) {
    SwingUtilities.updateComponentTreeUI(component);
    tell(component);
  }

  /** Tells the followers in a component whose look has been changed. */
  static void tell(Component component) {
    if (component instanceof LookFollower follower) {
      follower.lookChanged();
    }
    if (component instanceof Container container) {
      for (Component each : container.getComponents()) {
        tell(each);
      }
    }
  }
}
