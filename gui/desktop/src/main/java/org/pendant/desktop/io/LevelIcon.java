package org.pendant.desktop.io;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.RoundRectangle2D;
import javax.swing.Icon;
import org.pendant.kit.theme.Palette;

/**
 * A level: high and low differ in shape, not only in colour.
 *
 * @param form what it looks like
 * @param high whether it shows a high level
 */
record LevelIcon(Form form, boolean high) implements Icon {
  private static final int HEIGHT = 18;

  /** How a level is drawn. */
  enum Form {
    /** A slide that people move. */
    SWITCH,
    /** A light that they only see. */
    LAMP,
    /** A slide whose high position is a demand to stop. */
    ALARM
  }

  @Override
  public int getIconWidth() {
    return UIScale.scale(width());
  }

  @Override
  public int getIconHeight() {
    return UIScale.scale(HEIGHT);
  }

  /** In pixels before scaling, as all that is painted. */
  private int width() {
    return form == Form.LAMP ? HEIGHT : 2 * HEIGHT - 4;
  }

  @Override
  public void paintIcon(Component c, Graphics g, int x, int y) {
    Graphics2D pen = (Graphics2D) g.create();
    pen.translate(x, y);
    pen.scale(UIScale.scale(1f), UIScale.scale(1f));
    pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    pen.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    pen.setStroke(new BasicStroke(1.5f));
    Color on = form == Form.ALARM ? Palette.error() : Palette.ok();
    Color off = Palette.quiet();
    if (form == Form.LAMP) {
      paintLamp(pen, on, off);
    } else {
      paintSwitch(pen, on, off);
    }
    pen.dispose();
  }

  private void paintLamp(Graphics2D pen, Color on, Color off) {
    if (high) {
      pen.setColor(new Color(on.getRed(), on.getGreen(), on.getBlue(), 70));
      pen.fill(new Ellipse2D.Double(0.5, 0.5, 17, 17));
      pen.setColor(on);
      pen.fill(new Ellipse2D.Double(3, 3, 12, 12));
    } else {
      pen.setColor(off);
      pen.draw(new Ellipse2D.Double(4, 4, 10, 10));
    }
  }

  private void paintSwitch(Graphics2D pen, Color on, Color off) {
    double width = width() - 2.0;
    double height = HEIGHT - 2.0;
    RoundRectangle2D body = new RoundRectangle2D.Double(1, 1, width, height, height, height);
    if (high) {
      pen.setColor(on);
      pen.fill(body);
      pen.setColor(Palette.card());
      pen.fill(new Ellipse2D.Double(1 + width - height + 3, 4, height - 6, height - 6));
    } else {
      pen.setColor(off);
      pen.draw(body);
      pen.fill(new Ellipse2D.Double(5, 5, height - 8, height - 8));
    }
  }
}
