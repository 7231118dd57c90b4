package org.pendant.desktop.debug;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import javax.swing.Icon;
import org.pendant.kit.theme.Palette;

/**
 * A star: full for a favourite, an outline for what could be one.
 *
 * @param full whether it is a favourite
 * @param plain whether it has the colour of the text beside it, as in a selected row
 */
public record Star(boolean full, boolean plain) implements Icon {
  private static final int SIZE = 14;
  private static final int POINTS = 5;

  @Override
  public void paintIcon(Component on, Graphics g, int x, int y) {
    Graphics2D pen = (Graphics2D) g.create();
    pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    pen.translate(x + getIconWidth() / 2.0, y + getIconHeight() / 2.0);
    pen.setStroke(
        new BasicStroke(UIScale.scale(1.1f), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    pen.setColor(plain ? on.getForeground() : full ? Palette.warning() : Palette.quiet());
    Path2D star = outline(UIScale.scale(5.6f));
    if (full) {
      pen.fill(star);
    }
    pen.draw(star);
    pen.dispose();
  }

  private static Path2D outline(double radius) {
    Path2D star = new Path2D.Double();
    for (int i = 0; i < 2 * POINTS; i++) {
      double angle = Math.PI * i / POINTS - Math.PI / 2;
      double from = i % 2 == 0 ? radius : 0.45 * radius;
      double px = from * Math.cos(angle);
      double py = from * Math.sin(angle);
      if (i == 0) {
        star.moveTo(px, py);
      } else {
        star.lineTo(px, py);
      }
    }
    star.closePath();
    return star;
  }

  @Override
  public int getIconWidth() {
    return UIScale.scale(SIZE);
  }

  @Override
  public int getIconHeight() {
    return UIScale.scale(SIZE);
  }
}
