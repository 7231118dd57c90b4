package org.pendant.desktop.editor;

import com.formdev.flatlaf.util.UIScale;
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
import org.pendant.kit.theme.Palette;

/**
 * What stands beside one line: a breakpoint, the place where the program is, or both in one; or a
 * light bulb. Everything differs in shape, not only in colour.
 */
public record LineIcon(Optional<Dot> dot, Optional<Execution.State> arrow, boolean bulb)
    implements Icon {
  private static final int SIDE = 16;

  /**
   * A breakpoint.
   *
   * @param filled whether it is enabled; a ring otherwise
   * @param conditional has two bars in it
   */
  public record Dot(boolean filled, boolean conditional, Reach reach) {}

  /** Where a breakpoint stops the program. */
  public enum Reach {
    /** On the line itself. */
    HERE,
    /** On a line below: an arrow leads there. */
    BELOW,
    /** Nowhere: it is crossed out. */
    NOWHERE
  }

  @Override
  public int getIconWidth() {
    return UIScale.scale(SIDE);
  }

  @Override
  public int getIconHeight() {
    return UIScale.scale(SIDE);
  }

  @Override
  public void paintIcon(Component c, Graphics g, int x, int y) {
    Graphics2D pen = (Graphics2D) g.create();
    pen.translate(x, y);
    UIScale.scaleGraphics(pen);
    pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    pen.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    pen.setStroke(new BasicStroke(1.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    arrow.ifPresent(state -> paintArrow(pen, state, dot.isPresent()));
    dot.ifPresent(
        each -> {
          boolean leads = each.reach() == Reach.BELOW;
          if (arrow.isPresent()) {
            paintDot(pen, each, 2.5, leads ? 3.5 : 4.5, leads ? 5 : 7);
          } else {
            paintDot(pen, each, leads ? 4.5 : 3, leads ? 0.75 : 3, leads ? 7 : 10);
          }
        });
    if (bulb) {
      paintBulb(pen);
    }
    pen.dispose();
  }

  /** An outline while the program runs or a dot stands in it, filled where it is held. */
  private static void paintArrow(Graphics2D pen, Execution.State state, boolean around) {
    Path2D arrow = new Path2D.Double();
    arrow.moveTo(1.5, 2.5);
    arrow.lineTo(9.5, 2.5);
    arrow.lineTo(15, 8);
    arrow.lineTo(9.5, 13.5);
    arrow.lineTo(1.5, 13.5);
    arrow.closePath();
    Color color = state == Execution.State.FAILED ? Palette.error() : Palette.ok();
    boolean filled = state != Execution.State.RUNNING && !around;
    pen.setColor(filled ? color : Palette.tint(color, 0.25));
    pen.fill(arrow);
    pen.setColor(color);
    pen.draw(arrow);
    if (state == Execution.State.FAILED && !around) {
      pen.setColor(Palette.card());
      pen.draw(new Line2D.Double(7, 5, 7, 8.5));
      pen.draw(new Line2D.Double(7, 11, 7, 11));
    }
  }

  private static void paintDot(Graphics2D pen, Dot dot, double x, double y, double size) {
    Ellipse2D circle = new Ellipse2D.Double(x, y, size, size);
    pen.setColor(Palette.error());
    boolean filled = dot.filled() && dot.reach() != Reach.NOWHERE;
    if (filled) {
      pen.fill(circle);
    }
    pen.draw(circle);
    double middle = x + size / 2;
    double centre = y + size / 2;
    if (dot.conditional()) {
      pen.setColor(filled ? Palette.card() : Palette.error());
      pen.draw(new Line2D.Double(middle - 2, centre - 1.5, middle + 2, centre - 1.5));
      pen.draw(new Line2D.Double(middle - 2, centre + 1.5, middle + 2, centre + 1.5));
    }
    pen.setColor(Palette.error());
    switch (dot.reach()) {
      case HERE -> {}
      case BELOW -> {
        double end = y + size + 6.5;
        pen.draw(new Line2D.Double(middle, y + size + 2, middle, end));
        pen.draw(new Line2D.Double(middle - 2.5, end - 2.5, middle, end));
        pen.draw(new Line2D.Double(middle + 2.5, end - 2.5, middle, end));
      }
      case NOWHERE -> pen.draw(new Line2D.Double(x - 1.5, y + size + 1.5, x + size + 1.5, y - 1.5));
    }
  }

  private static void paintBulb(Graphics2D pen) {
    pen.setColor(Palette.warning());
    pen.draw(new Ellipse2D.Double(4, 2, 8, 8));
    pen.draw(new Line2D.Double(6.5, 12, 9.5, 12));
    pen.draw(new Line2D.Double(7, 14, 9, 14));
  }
}
