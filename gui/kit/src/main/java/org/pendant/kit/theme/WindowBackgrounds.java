package org.pendant.kit.theme;

import java.awt.Color;
import java.awt.Window;
import java.util.stream.Stream;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.RootPaneContainer;
import javax.swing.UIManager;
import javax.swing.plaf.UIResource;

/**
 * Backgrounds of windows while the look changes. On X11 a window whose background is set is painted
 * at once; the look and feel does so before it comes to what is in the window, and people would see
 * it half in the old colours and half in the new ones. Only the dispatch thread calls this.
 */
final class WindowBackgrounds {
  private WindowBackgrounds() {}

  /** Has the look and feel leave the backgrounds alone; before anything changes. */
  static void hold() {
    windows()
        .filter(each -> each.getBackground() instanceof UIResource)
        .forEach(
            each -> {
              ((RootPaneContainer) each).getRootPane().putClientProperty(key(), true);
              each.setBackground(new Color(each.getBackground().getRGB()));
            });
  }

  /** Gives the windows the background of now; after everything in them has changed. */
  static void follow() {
    Color now = new Color(UIManager.getColor("control").getRGB());
    windows()
        .filter(each -> ((RootPaneContainer) each).getRootPane().getClientProperty(key()) != null)
        .forEach(each -> each.setBackground(now));
  }

  private static Object key() {
    return WindowBackgrounds.class;
  }

  /** Those whose background the look and feel would set. */
  private static Stream<Window> windows() {
    return Stream.of(Window.getWindows())
        .filter(each -> each instanceof JFrame || each instanceof JDialog);
  }
}
