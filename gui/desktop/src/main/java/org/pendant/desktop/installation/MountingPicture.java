package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.Locale;
import javax.swing.JPanel;
import org.pendant.controller.installation.BaseMounting;
import org.pendant.kit.theme.Palette;

/**
 * Mounting picture: the base from the side, tilted, with its axes and gravity; and from above its
 * plate, turned.
 */
@SuppressWarnings("serial") // never written to a stream
final class MountingPicture extends JPanel {
  private transient BaseMounting mounting = BaseMounting.FLOOR;

  MountingPicture() {
    setName("mounting-picture");
    setOpaque(false);
    getAccessibleContext().setAccessibleName(text("howTheBaseIsMounted"));
  }

  void show(BaseMounting next) {
    mounting = next;
    getAccessibleContext()
        .setAccessibleDescription(
            String.format(
                Locale.ROOT,
                text("tiltedAndRotated"),
                Math.toDegrees(next.tiltRad()),
                Math.toDegrees(next.rotationRad())));
    repaint();
  }

  @Override
  public Dimension getPreferredSize() {
    return new Dimension(UIScale.scale(320), UIScale.scale(170));
  }

  @Override
  protected void paintComponent(Graphics g) {
    Graphics2D painter = (Graphics2D) g.create();
    painter.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    double size = Math.min(getHeight(), getWidth() / 2.0);
    painter.setStroke(new BasicStroke(UIScale.scale(2f)));
    drawSide(painter, size / 2, getHeight() / 2.0, size);
    drawTop(painter, size * 1.55, getHeight() / 2.0, size);
    painter.dispose();
  }

  private void drawSide(Graphics2D painter, double x, double y, double size) {
    AffineTransform before = painter.getTransform();
    painter.translate(x, y);
    double unit = size / 8;
    painter.rotate(mounting.tiltRad());
    painter.setColor(Palette.quiet());
    painter.fill(new Rectangle2D.Double(-2.2 * unit, 0, 4.4 * unit, 0.35 * unit));
    painter.setColor(Palette.tint(Palette.accent(), 0.35));
    painter.fill(new Rectangle2D.Double(-0.8 * unit, -1.3 * unit, 1.6 * unit, 1.3 * unit));
    painter.setColor(Palette.accent());
    painter.draw(new Rectangle2D.Double(-0.8 * unit, -1.3 * unit, 1.6 * unit, 1.3 * unit));
    arrow(painter, 0, -1.3 * unit, 0, -3 * unit, "z");
    painter.setTransform(before);
    painter.translate(x, y);
    painter.setColor(Palette.warning());
    arrow(painter, 3 * unit, -1.5 * unit, 3 * unit, 1.5 * unit, "g");
    painter.setTransform(before);
  }

  private void drawTop(Graphics2D painter, double x, double y, double size) {
    AffineTransform before = painter.getTransform();
    painter.translate(x, y);
    double unit = size / 8;
    painter.setColor(Palette.quiet());
    painter.draw(new Ellipse2D.Double(-1.8 * unit, -1.8 * unit, 3.6 * unit, 3.6 * unit));
    axis(painter, mounting.rotationRad(), 2.6 * unit, "x", Palette.error());
    axis(painter, mounting.rotationRad() + Math.PI / 2, 2.6 * unit, "y", Palette.ok());
    painter.setTransform(before);
  }

  /** Seen from above, a positive turn goes against the clock. */
  private static void axis(
      Graphics2D painter, double rad, double length, String name, Color color) {
    painter.setColor(color);
    arrow(painter, 0, 0, length * Math.cos(rad), -length * Math.sin(rad), name);
  }

  private static void arrow(
      Graphics2D painter, double fromX, double fromY, double toX, double toY, String name) {
    painter.draw(new Line2D.Double(fromX, fromY, toX, toY));
    double angle = Math.atan2(toY - fromY, toX - fromX);
    double head = UIScale.scale(7f);
    Path2D tip = new Path2D.Double();
    tip.moveTo(toX, toY);
    tip.lineTo(toX - head * Math.cos(angle - 0.45), toY - head * Math.sin(angle - 0.45));
    tip.lineTo(toX - head * Math.cos(angle + 0.45), toY - head * Math.sin(angle + 0.45));
    tip.closePath();
    painter.fill(tip);
    int off = UIScale.scale(5);
    painter.drawString(name, (float) toX + off, (float) toY - off);
  }
}
