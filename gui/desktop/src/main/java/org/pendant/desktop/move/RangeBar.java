package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.RoundRectangle2D;
import java.util.OptionalDouble;
import javax.swing.JComponent;
import javax.swing.UIManager;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.kit.theme.Palette;

/**
 * Range bar: where a joint is within its range, and where that ends; near either end in the colour
 * of a warning.
 */
@SuppressWarnings("serial") // never written to a stream
final class RangeBar extends JComponent {
  private static final int HEIGHT = 20;
  private static final int TEXT_GAP = 1;
  private static final int MIN_WIDTH = 80;
  private static final double KNOB = 12;

  /** Share of the range at either end that counts as near it. */
  private static final double NEAR_END = 0.03;

  private double share = 0.5;
  private boolean unlimited;
  private double goalShare = -1;
  private String lowEnd = "";
  private String highEnd = "";

  @Override
  public Dimension getPreferredSize() {
    return new Dimension(MIN_WIDTH, HEIGHT + TEXT_GAP + getFontMetrics(endFont()).getHeight());
  }

  @Override
  public Dimension getMinimumSize() {
    return getPreferredSize();
  }

  private Font endFont() {
    Font label = UIManager.getFont("mini.font");
    return label == null ? UIManager.getFont("Label.font") : label;
  }

  /**
   * Shows a position, and the goal that the user typed.
   *
   * @param unit in which the ends are written
   */
  void show(JointRange range, double positionRad, OptionalDouble goalRad, DisplayUnit unit) {
    String low = range.unlimited() ? text("noEnd") : endText(range.minRad(), unit);
    String high = range.unlimited() ? "" : endText(range.maxRad(), unit);
    if (!low.equals(lowEnd) || !high.equals(highEnd)) {
      lowEnd = low;
      highEnd = high;
      repaint();
    }
    double shown = range.share(positionRad);
    double goal = goalRad.isPresent() ? range.share(goalRad.getAsDouble()) : -1;
    if (shown != share || goal != goalShare || unlimited != range.unlimited()) {
      share = shown;
      goalShare = goal;
      unlimited = range.unlimited();
      repaint();
    }
  }

  private static String endText(double positionRad, DisplayUnit unit) {
    return unit.shortText(positionRad) + (unit == DisplayUnit.DEGREE ? "\u00b0" : "");
  }

  @Override
  protected void paintComponent(Graphics g) {
    Graphics2D pen = (Graphics2D) g.create();
    pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    pen.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    double middle = HEIGHT / 2.0;
    double length = getWidth() - KNOB;
    double x = share * length;
    boolean nearEnd = !unlimited && (share < NEAR_END || share > 1 - NEAR_END);
    pen.setColor(Palette.line());
    pen.fill(new RoundRectangle2D.Double(KNOB / 2, middle - 2, length, 4, 4, 4));
    pen.setColor(Palette.quiet());
    pen.fill(new RoundRectangle2D.Double(KNOB / 2 + length / 2 - 0.5, middle - 5, 1, 10, 1, 1));
    if (goalShare >= 0) {
      paintGoal(pen, KNOB / 2 + goalShare * length, middle);
    }
    pen.setColor(nearEnd ? Palette.warning() : Palette.accent());
    pen.fill(new Ellipse2D.Double(x, middle - KNOB / 2, KNOB, KNOB));
    paintEnds(pen);
    pen.dispose();
  }

  private void paintEnds(Graphics2D pen) {
    pen.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    pen.setFont(endFont());
    pen.setColor(Palette.quiet());
    FontMetrics metrics = pen.getFontMetrics();
    int y = HEIGHT + TEXT_GAP + metrics.getAscent();
    pen.drawString(lowEnd, 0, y);
    pen.drawString(highEnd, getWidth() - metrics.stringWidth(highEnd), y);
  }

  private static void paintGoal(Graphics2D pen, double x, double middle) {
    Path2D mark = new Path2D.Double();
    mark.moveTo(x, middle - 3);
    mark.lineTo(x - 4, middle - 9);
    mark.lineTo(x + 4, middle - 9);
    mark.closePath();
    pen.setColor(Palette.quiet());
    pen.fill(mark);
  }
}
