package org.pendant.desktop.program;

import java.awt.Component;
import java.awt.KeyboardFocusManager;
import javax.swing.JLayeredPane;
import javax.swing.MenuSelectionManager;

/** Key target: what keys that delete, copy and the like are meant for. */
final class KeyTarget {
  private KeyTarget() {}

  /** Whether that is {@code wanted}: it has the keys, or a menu or a panel over the window acts. */
  static boolean now(Component wanted) {
    Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
    return owner == null
        || wanted.isFocusOwner()
        || MenuSelectionManager.defaultManager().getSelectedPath().length > 0
        || overWindow(owner);
  }

  private static boolean overWindow(Component component) {
    for (Component each = component; each != null; each = each.getParent()) {
      if (each.getParent() instanceof JLayeredPane layers) {
        return layers.getLayer(each) > JLayeredPane.DEFAULT_LAYER;
      }
    }
    return false;
  }
}
