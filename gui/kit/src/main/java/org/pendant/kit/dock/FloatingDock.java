package org.pendant.kit.dock;

import static org.pendant.kit.dock.DockTexts.text;

import java.awt.BorderLayout;
import java.awt.Rectangle;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JFrame;

/** Floating dock: a view in a window of its own, for a second screen, say. */
final class FloatingDock {
  private final Dockable view;
  private final DockPlan plan;
  private final JFrame window;

  /**
   * A window that is not open yet.
   *
   * @param furnish gives it what all windows have
   * @param putBack runs when people close it: the view goes back into a dock
   */
  FloatingDock(Dockable view, DockPlan plan, Consumer<JFrame> furnish, Runnable putBack) {
    this.view = view;
    this.plan = plan;
    window = new JFrame(text("windowOfAPanel", view.title()));
    window.setName("window-" + view.id());
    window.setDefaultCloseOperation(JFrame.DO_NOTHING_ON_CLOSE);
    window.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosing(WindowEvent event) {
            putBack.run();
          }
        });
    furnish.accept(window);
  }

  /**
   * Opens it with the view, unless it is open.
   *
   * @param takesKeys whether the keyboard goes to it; a start leaves that to the main window
   */
  void open(Rectangle bounds, boolean takesKeys) {
    if (window.isVisible()) {
      return;
    }
    window.getContentPane().add(view.component(), BorderLayout.CENTER);
    // Tabs hide what is not in front.
    view.component().setVisible(true);
    window.setBounds(bounds);
    window.setAutoRequestFocus(takesKeys);
    window.setVisible(true);
    window.setAutoRequestFocus(true);
  }

  /** Where it is; empty while it is not open. */
  Optional<Rectangle> bounds() {
    return window.isVisible() ? Optional.of(window.getBounds()) : Optional.empty();
  }

  /** Puts it above the main window, which keeps the keyboard. */
  void raise() {
    if (window.isVisible()) {
      window.setFocusableWindowState(false);
      window.toFront();
      window.setFocusableWindowState(true);
    }
  }

  /** Closes it and remembers where it was; the view may go elsewhere. */
  void close() {
    if (window.isVisible()) {
      plan.setWindowBounds(view.id(), window.getBounds());
      window.getContentPane().removeAll();
      window.dispose();
    }
  }
}
