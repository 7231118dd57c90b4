package org.pendant.desktop.shell;

import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.event.ActionEvent;
import java.util.Set;
import javax.swing.AbstractAction;
import javax.swing.ActionMap;
import javax.swing.InputMap;
import javax.swing.JComponent;
import javax.swing.JRootPane;
import javax.swing.KeyStroke;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;

/** Key bindings: binds the keys of all actions in a window, again after each change. */
final class KeyBindings {
  private final JRootPane root;
  private final ActionTable actions;
  private boolean stale;

  private KeyBindings(JRootPane root, ActionTable actions) {
    this.root = root;
    this.actions = actions;
  }

  /** Binds the keys of {@code actions} in a window from now on. */
  static void bind(JRootPane root, ActionTable actions) {
    // Ctrl+Tab is an action's; Tab alone leads from one part to the next
    root.setFocusTraversalKeys(
        KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, Set.of(KeyStroke.getKeyStroke("TAB")));
    root.setFocusTraversalKeys(
        KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, Set.of(KeyStroke.getKeyStroke("shift TAB")));
    KeyBindings bindings = new KeyBindings(root, actions);
    actions.addListener(bindings::bindSoon);
    bindings.bind();
  }

  /** Once for all the changes that come together. */
  private void bindSoon() {
    if (!stale) {
      stale = true;
      EventQueue.invokeLater(this::bind);
    }
  }

  private void bind() {
    stale = false;
    InputMap keys = new InputMap();
    ActionMap runs = new ActionMap();
    for (Action each : actions.all()) {
      actions.strokeOf(each.id()).ifPresent(stroke -> bind(stroke, each, keys, runs));
    }
    InputMap window = root.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW);
    window.clear();
    for (KeyStroke stroke : keys.keys() == null ? new KeyStroke[0] : keys.keys()) {
      window.put(stroke, keys.get(stroke));
    }
    for (Object id : runs.keys() == null ? new Object[0] : runs.keys()) {
      root.getActionMap().put(id, runs.get(id));
    }
  }

  private void bind(KeyStroke stroke, Action action, InputMap keys, ActionMap runs) {
    if (keys.get(stroke) != null) {
      // The first one has the key; the key editor shows the conflict.
      return;
    }
    keys.put(stroke, action.id());
    runs.put(
        action.id(),
        new AbstractAction() {
          @Override
          public boolean accept(Object sender) {
            return action.enabled().getAsBoolean();
          }

          @Override
          public void actionPerformed(ActionEvent event) {
            actions.run(action.id());
          }
        });
  }
}
