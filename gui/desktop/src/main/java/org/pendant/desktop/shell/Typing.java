package org.pendant.desktop.shell;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.concurrent.TimeUnit;
import javax.swing.JLayeredPane;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;

/**
 * Typing detection: whether keys have a purposeful target, so that nothing that happens by itself
 * may take the focus away.
 */
final class Typing {
  /** A user who has typed within this time will continue. */
  private static final long PAUSE_NS = TimeUnit.SECONDS.toNanos(2);

  private final AWTEventListener listener = this::see;
  private long lastNs = System.nanoTime() - PAUSE_NS;

  /** Notices what is typed, until {@link #stop}. */
  void start() {
    Toolkit.getDefaultToolkit().addAWTEventListener(listener, AWTEvent.KEY_EVENT_MASK);
  }

  void stop() {
    Toolkit.getDefaultToolkit().removeAWTEventListener(listener);
  }

  private void see(AWTEvent event) {
    if (event.getID() == KeyEvent.KEY_TYPED
        && event.getSource() instanceof JTextComponent text
        && text.isEditable()) {
      lastNs = System.nanoTime();
    }
  }

  /** Whether the user is writing somewhere just now. */
  boolean going() {
    return System.nanoTime() - lastNs < PAUSE_NS;
  }

  /** Whether the user is writing in a text of {@code view} just now. */
  boolean within(Component view) {
    return !asked()
        && owner() instanceof JTextComponent text
        && SwingUtilities.isDescendingFrom(text, view)
        && going();
  }

  /** Whether keys go to a panel over the window, or to a field that is not in {@code view}. */
  boolean elsewhere(Component view) {
    Component owner = owner();
    if (asked() || owner == null) {
      return false;
    }
    boolean field =
        owner instanceof JTextComponent text
            && text.isEditable()
            && !SwingUtilities.isDescendingFrom(owner, view);
    return field || overWindow(owner);
  }

  /** Whether what happens now is what a key or a click has asked for. */
  private static boolean asked() {
    return EventQueue.getCurrentEvent() instanceof InputEvent;
  }

  private static Component owner() {
    return KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
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
