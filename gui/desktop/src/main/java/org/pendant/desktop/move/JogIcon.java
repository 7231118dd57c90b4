package org.pendant.desktop.move;

import java.awt.BasicStroke;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Arc2D;
import java.awt.geom.Path2D;
import javax.swing.Icon;
import javax.swing.UIManager;
import org.pendant.kit.theme.Palette;

/**
 * An arrow, or an arrow that goes round.
 *
 * @param form of the arrow
 * @param quarters by how many quarter turns it is turned counter-clockwise; 0 points right
 */
record JogIcon(Form form, int quarters) implements Icon {
  private static final int SIZE = 18;

  /** What the arrow looks like. */
  enum Form {
    STRAIGHT,
    CLOCKWISE,
    COUNTER_CLOCKWISE
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
    pen.translate(x + SIZE / 2.0, y + SIZE / 2.0);
    pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    pen.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    pen.setStroke(new BasicStroke(1.75f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    pen.setColor(c.isEnabled() ? Palette.accent() : UIManager.getColor("Button.disabledText"));
    if (form == Form.STRAIGHT) {
      pen.rotate(-quarters * Math.PI / 2);
      paintStraight(pen);
    } else {
      if (form == Form.CLOCKWISE) {
        pen.scale(-1, 1);
      }
      paintRound(pen);
    }
    pen.dispose();
  }

  private static void paintStraight(Graphics2D pen) {
    Path2D arrow = new Path2D.Double();
    arrow.moveTo(-6.5, 0);
    arrow.lineTo(6.5, 0);
    arrow.moveTo(1.5, -5);
    arrow.lineTo(6.5, 0);
    arrow.lineTo(1.5, 5);
    pen.draw(arrow);
  }

  /** Three quarters of a circle, counter-clockwise, open at the top left. */
  private static void paintRound(Graphics2D pen) {
    pen.draw(new Arc2D.Double(-6, -6, 12, 12, -120, 240, Arc2D.OPEN));
    Path2D head = new Path2D.Double();
    head.moveTo(1.5, -8.5);
    head.lineTo(-3, -5.2);
    head.lineTo(0.5, -1);
    pen.draw(head);
  }
}
