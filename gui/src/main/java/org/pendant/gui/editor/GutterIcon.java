package org.pendant.gui.editor;

import java.awt.BasicStroke;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import javax.swing.Icon;
import org.pendant.gui.workbench.Palette;

/** What stands beside a line. The shapes differ, not only the colours. */
enum GutterIcon implements Icon {
  BREAKPOINT,
  EXECUTION,
  BULB;

  private static final int SIZE = 14;

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
    pen.setStroke(new BasicStroke(1.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    switch (this) {
      case BREAKPOINT -> {
        pen.setColor(Palette.error());
        pen.fill(new Ellipse2D.Double(2, 2, 10, 10));
      }
      case EXECUTION -> {
        Path2D arrow = new Path2D.Double();
        arrow.moveTo(2, 4.5);
        arrow.lineTo(7, 4.5);
        arrow.lineTo(7, 1.5);
        arrow.lineTo(13, 7);
        arrow.lineTo(7, 12.5);
        arrow.lineTo(7, 9.5);
        arrow.lineTo(2, 9.5);
        arrow.closePath();
        pen.setColor(Palette.ok());
        pen.fill(arrow);
      }
      case BULB -> {
        pen.setColor(Palette.warning());
        pen.draw(new Ellipse2D.Double(3, 1, 8, 8));
        pen.draw(new Line2D.Double(5.5, 11, 8.5, 11));
        pen.draw(new Line2D.Double(6, 13, 8, 13));
      }
    }
    pen.dispose();
  }
}
