package org.pendant.desktop.shell;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Rectangle;
import javax.swing.JComponent;
import javax.swing.UIManager;

/**
 * Outline of the window: the lines between its parts, painted while these are made. They are where
 * the parts will have their edges.
 */
@SuppressWarnings("serial") // never written to a stream
final class WindowOutline extends JComponent {
  /** Sizes in pixels before scaling. */
  private static final int MENU_BAR = 24;

  private static final int HEADER = 46;
  private static final int RAIL = 86;
  private static final int FOOTER = 52;

  /** Where screens and panels will be, in a window with {@code size} between its edges. */
  static Rectangle middle(Dimension size) {
    int x = UIScale.scale(RAIL);
    int y = UIScale.scale(MENU_BAR + HEADER);
    return new Rectangle(x, y, size.width - x, size.height - y - UIScale.scale(FOOTER));
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    Rectangle middle = middle(getSize());
    int menus = UIScale.scale(MENU_BAR);
    int end = middle.y + middle.height;
    graphics.setColor(UIManager.getColor("MenuBar.background"));
    graphics.fillRect(0, 0, getWidth(), menus);
    graphics.setColor(UIManager.getColor("Component.borderColor"));
    graphics.drawLine(0, menus, getWidth(), menus);
    graphics.drawLine(0, middle.y, getWidth(), middle.y);
    graphics.drawLine(middle.x, middle.y, middle.x, end);
    graphics.drawLine(0, end, getWidth(), end);
  }
}
