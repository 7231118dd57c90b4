package org.pendant.kit.theme;

import java.awt.event.ActionEvent;
import java.util.Arrays;
import java.util.Optional;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.ActionMap;
import javax.swing.JMenu;
import javax.swing.JPopupMenu;
import javax.swing.MenuElement;
import javax.swing.MenuSelectionManager;
import javax.swing.UIManager;

/**
 * Submenu keys: has the key that leads into a submenu do so where the pointer has opened that
 * already. Swing takes the entry for one without a submenu then, and goes on to the next menu of
 * the menu bar.
 */
final class SubmenuKeys {
  /** What Swing calls the keys of all menus, and the one that leads into a submenu. */
  private static final String KEYS = "PopupMenu.actionMap";

  private static final String INTO = "selectChild";

  private SubmenuKeys() {}

  /** For all menus; Swing makes the keys with the first one and keeps them. */
  static void install() {
    new JPopupMenu(); // makes them
    if (UIManager.get(KEYS) instanceof ActionMap keys && !(keys.get(INTO) instanceof Into)) {
      keys.put(INTO, new Into(keys.get(INTO)));
    }
  }

  /** Goes into the submenu that is open, or does what Swing does. */
  @SuppressWarnings("serial") // never written to a stream
  static final class Into extends AbstractAction {
    private final transient Action otherwise;

    Into(Action otherwise) {
      this.otherwise = otherwise;
    }

    @Override
    public void actionPerformed(ActionEvent event) {
      MenuSelectionManager menus = MenuSelectionManager.defaultManager();
      MenuElement[] path = menus.getSelectedPath();
      if (path.length > 0
          && path[path.length - 1] instanceof JPopupMenu submenu
          && submenu.getInvoker() instanceof JMenu entry
          && !entry.isTopLevelMenu()) {
        first(submenu).ifPresent(each -> menus.setSelectedPath(with(path, each)));
      } else {
        otherwise.actionPerformed(event);
      }
    }

    private static Optional<MenuElement> first(JPopupMenu menu) {
      return Arrays.stream(menu.getSubElements())
          .filter(each -> each.getComponent().isEnabled() && each.getComponent().isVisible())
          .findFirst();
    }

    private static MenuElement[] with(MenuElement[] path, MenuElement last) {
      MenuElement[] longer = Arrays.copyOf(path, path.length + 1);
      longer[path.length] = last;
      return longer;
    }
  }
}
