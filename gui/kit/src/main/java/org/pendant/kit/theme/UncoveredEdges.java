package org.pendant.kit.theme;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.GraphicsConfiguration;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.event.PaintEvent;
import javax.swing.RootPaneContainer;

/**
 * Paints all pixels of a window that another one uncovers, such as a menu that closes. With two
 * pixels to a point a window may begin at an odd pixel; AWT then takes the uncovered part for half
 * a point less, and what was there would stay as a line.
 */
final class UncoveredEdges {
  private UncoveredEdges() {}

  /** Begins to look after all windows of this program. */
  static void follow() {
    Toolkit.getDefaultToolkit()
        .addAWTEventListener(UncoveredEdges::painted, AWTEvent.PAINT_EVENT_MASK);
  }

  private static void painted(AWTEvent event) {
    if (event instanceof PaintEvent paint
        && paint.getID() == PaintEvent.PAINT
        && paint.getComponent() instanceof RootPaneContainer window
        && pixelsPerPoint(paint.getComponent()) > 1) {
      repaint(window, paint.getUpdateRect());
    }
  }

  private static double pixelsPerPoint(Component component) {
    GraphicsConfiguration screen = component.getGraphicsConfiguration();
    return screen == null ? 1 : screen.getDefaultTransform().getScaleX();
  }

  /** Repaints {@code uncovered}, in points of the window, and one point around it. */
  static void repaint(RootPaneContainer window, Rectangle uncovered) {
    Rectangle all = new Rectangle(uncovered);
    all.grow(1, 1);
    all.translate(-window.getRootPane().getX(), -window.getRootPane().getY());
    window.getRootPane().repaint(all);
  }
}
