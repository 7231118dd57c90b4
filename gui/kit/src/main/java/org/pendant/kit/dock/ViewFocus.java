package org.pendant.kit.dock;

import java.awt.Component;
import java.awt.Container;
import java.awt.KeyboardFocusManager;
import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JTable;
import javax.swing.JTree;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;

/**
 * View focus: where keys are sent in a view that comes to the front: where they went last, at first
 * to the part that says so ({@link Dockable#TAKES_KEYS}), else to its text, table, tree or list.
 * Never to a button that the user has not chosen: a space would press it.
 */
final class ViewFocus {
  private final Map<Dockable, Component> last = new HashMap<>();

  ViewFocus(Collection<Dockable> views) {
    KeyboardFocusManager.getCurrentKeyboardFocusManager()
        .addPropertyChangeListener(
            "permanentFocusOwner",
            event -> {
              if (event.getNewValue() instanceof Component owner) {
                views.stream()
                    .filter(each -> SwingUtilities.isDescendingFrom(owner, each.component()))
                    .forEach(each -> last.put(each, owner));
              }
            });
  }

  /** Gives the focus to a view. */
  void give(Dockable view) {
    JComponent whole = view.component();
    Component there = last.get(view);
    boolean given =
        there != null
            && canTakeKeys(there)
            && SwingUtilities.isDescendingFrom(there, whole)
            && (there.isFocusOwner() || there.requestFocusInWindow());
    if (!given) {
      first(whole, ViewFocus::takesKeys)
          .or(() -> first(whole, ViewFocus::isContent))
          .orElse(whole)
          .requestFocusInWindow();
    }
  }

  /** A button may have been disabled since it had the keys. */
  private static boolean canTakeKeys(Component component) {
    return component.isShowing() && component.isEnabled() && component.isFocusable();
  }

  /** Whether keys go to a component or to something in it. */
  static boolean within(Component component) {
    Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
    return owner != null && SwingUtilities.isDescendingFrom(owner, component);
  }

  private static Optional<Component> first(Container in, Predicate<Component> wanted) {
    for (Component each : in.getComponents()) {
      if (!each.isVisible()) {
        continue;
      }
      if (wanted.test(each)) {
        return Optional.of(each);
      }
      if (each instanceof Container inner) {
        Optional<Component> found = first(inner, wanted);
        if (found.isPresent()) {
          return found;
        }
      }
    }
    return Optional.empty();
  }

  private static boolean takesKeys(Component component) {
    return component instanceof JComponent part
        && Boolean.TRUE.equals(part.getClientProperty(Dockable.TAKES_KEYS));
  }

  private static boolean isContent(Component component) {
    boolean kind =
        component instanceof JTable
            || component instanceof JTree
            || component instanceof JList
            || (component instanceof JTextComponent text
                && text.isEditable()
                && !(text instanceof javax.swing.JTextField));
    return kind && component.isFocusable() && component.isEnabled();
  }
}
