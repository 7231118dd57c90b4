package org.pendant.window;

import java.awt.Component;
import java.awt.Rectangle;
import java.awt.event.MouseEvent;
import javax.swing.JComponent;

/** What tool tips tell. Only the dispatch thread calls it. */
final class ToolTips {
  private ToolTips() {}

  /** Whether the tool tip of a component, or of what is around it, has all of a text. */
  static boolean toldAround(Component component, String text) {
    for (Component each = component; each != null; each = each.getParent()) {
      if (each instanceof JComponent inside && tells(inside.getToolTipText(), text)) {
        return true;
      }
    }
    return false;
  }

  /** Whether a tool tip has all of a text. */
  static boolean tells(String tip, String text) {
    return tip != null && plain(tip).contains(plain(text));
  }

  /** A text without marks of HTML, and with one blank between words. */
  static String plain(String text) {
    return text.replaceAll("<[^>]*>", " ")
        .replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&amp;", "&")
        .replaceAll("\\s+", " ")
        .strip();
  }

  /** The pointer in the middle of a cell. */
  static MouseEvent pointing(JComponent at, Rectangle cell) {
    int x = (int) cell.getCenterX();
    int y = (int) cell.getCenterY();
    return new MouseEvent(at, MouseEvent.MOUSE_MOVED, 0, 0, x, y, 0, false);
  }

  /** Whether there is nothing to read. */
  static boolean blank(String text) {
    return text == null || plain(text).isEmpty();
  }
}
