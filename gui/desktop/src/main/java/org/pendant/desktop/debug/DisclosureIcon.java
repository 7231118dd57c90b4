package org.pendant.desktop.debug;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import javax.swing.Icon;

/**
 * Disclosure icon: the arrow beside a value that unfolds, indented by its level.
 *
 * @param level 0 for the outermost
 */
record DisclosureIcon(int level, boolean shown, boolean unfolded) implements Icon {
  private static final int STEP = 14;

  /** Where the arrow ends, in pixels from the cell's edge. */
  static int end(int level) {
    return UIScale.scale(4 + STEP * (level + 1));
  }

  @Override
  public void paintIcon(Component on, Graphics g, int x, int y) {
    if (!shown) {
      return;
    }
    Graphics2D pen = (Graphics2D) g.create();
    pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    pen.setColor(on.getForeground());
    pen.translate(x + UIScale.scale(STEP * level + 7), y + getIconHeight() / 2.0);
    if (unfolded) {
      pen.rotate(Math.PI / 2);
    }
    double size = UIScale.scale(3.5f);
    Path2D arrow = new Path2D.Double();
    arrow.moveTo(-size / 2, -size);
    arrow.lineTo(size / 2, 0);
    arrow.lineTo(-size / 2, size);
    pen.setStroke(
        new BasicStroke(UIScale.scale(1.6f), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    pen.draw(arrow);
    pen.dispose();
  }

  @Override
  public int getIconWidth() {
    return UIScale.scale(STEP * (level + 1));
  }

  @Override
  public int getIconHeight() {
    return UIScale.scale(14);
  }
}
