package org.pendant.desktop.log;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.Optional;
import javax.swing.Icon;
import org.pendant.controller.message.LogEntry.Level;

/**
 * A circle, a triangle or an octagon: severities differ in shape, not only in colour.
 *
 * @param color empty for that of the severity
 */
record SeverityIcon(Level level, Optional<Color> color) implements Icon {
  private static final int SIZE = 16;

  SeverityIcon(Level level) {
    this(level, Optional.empty());
  }

  @Override
  public int getIconWidth() {
    return SIZE;
  }

  @Override
  public int getIconHeight() {
    return SIZE;
  }

  @Override
  public void paintIcon(Component c, Graphics g, int x, int y) {
    Graphics2D pen = (Graphics2D) g.create();
    pen.translate(x, y);
    pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    pen.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    pen.setColor(color.orElseGet(() -> LogColors.of(level)));
    pen.setStroke(new BasicStroke(1.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    switch (level) {
      case INFO -> {
        pen.draw(new Ellipse2D.Double(2, 2, 12, 12));
        pen.draw(new Line2D.Double(8, 7.5, 8, 11));
        pen.draw(new Line2D.Double(8, 5, 8, 5));
      }
      case WARNING -> {
        pen.draw(polygon(8, 2, 14.5, 13.5, 1.5, 13.5));
        pen.draw(new Line2D.Double(8, 6.5, 8, 9.5));
        pen.draw(new Line2D.Double(8, 11.5, 8, 11.5));
      }
      case ERROR -> {
        pen.fill(polygon(5, 1.5, 11, 1.5, 14.5, 5, 14.5, 11, 11, 14.5, 5, 14.5, 1.5, 11, 1.5, 5));
        pen.setColor(c.getBackground());
        pen.draw(new Line2D.Double(5.5, 5.5, 10.5, 10.5));
        pen.draw(new Line2D.Double(10.5, 5.5, 5.5, 10.5));
      }
    }
    pen.dispose();
  }

  private static Path2D polygon(double... corners) {
    Path2D path = new Path2D.Double();
    path.moveTo(corners[0], corners[1]);
    for (int i = 2; i < corners.length; i += 2) {
      path.lineTo(corners[i], corners[i + 1]);
    }
    path.closePath();
    return path;
  }
}
