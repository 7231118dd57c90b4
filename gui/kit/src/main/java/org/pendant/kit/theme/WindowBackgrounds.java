package org.pendant.kit.theme;

import java.awt.Color;
import java.awt.Window;
import java.util.stream.Stream;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.plaf.UIResource;

/**
 * Backgrounds of windows while the look changes: what a window shows where none of its parts is
 * painted, which is seen for a moment at most, while it becomes larger.
 *
 * <p>On X11 a window whose background is set to another colour is cleared, and painted at once and
 * without a buffer: people would see it empty and built up part by part, for a quarter of a second
 * where there are many. The look and feel sets it before it comes to what is in the window; to set
 * it at the end was tried, and clears the window all the same. So it stays what it was at first.
 */
final class WindowBackgrounds {
  private WindowBackgrounds() {}

  /**
   * Has the look and feel leave the backgrounds alone; before anything changes, on the dispatch
   * thread.
   */
  static void hold() {
    Stream.of(Window.getWindows())
        .filter(each -> each instanceof JFrame || each instanceof JDialog)
        .filter(each -> each.getBackground() instanceof UIResource)
        // an equal colour clears nothing
        .forEach(each -> each.setBackground(new Color(each.getBackground().getRGB())));
  }
}
