package org.pendant.desktop.cell;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.CubicCurve2D;
import java.awt.geom.RoundRectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import org.pendant.kit.theme.Palette;

/** Wire layer: draws wires over the lists that they go between; the pointer goes through it. */
@SuppressWarnings("serial") // never written to a stream
final class WireLayer extends JComponent {
  private static final float LOW_PX = 1.4f;
  private static final float HIGH_PX = 2.6f;
  private static final float CHOSEN_PX = 3.4f;
  private static final float NEAR_PX = 5;

  private List<Wire> wires = List.of();
  private Optional<Loose> loose = Optional.empty();

  /**
   * A wire.
   *
   * @param port where it begins
   * @param from its end at the controller
   * @param to its end at the device
   * @param away whether one of its ends is out of sight
   */
  record Wire(WirePort port, Point from, Point to, boolean high, boolean chosen, boolean away) {
    Shape curve() {
      return between(from, to);
    }
  }

  /**
   * A wire that is being drawn.
   *
   * @param refused whether it cannot end where the pointer is
   * @param words what is said at the pointer; empty for nothing
   */
  record Loose(Point from, Point pointer, boolean refused, String words) {}

  WireLayer() {
    setOpaque(false);
  }

  @Override
  public boolean contains(int x, int y) {
    return false;
  }

  void show(List<Wire> next, Optional<Loose> drawn) {
    if (!next.equals(wires) || !drawn.equals(loose)) {
      wires = next;
      loose = drawn;
      repaint();
    }
  }

  /** The wire at a point; empty for none. */
  Optional<Wire> at(Point point) {
    float near = UIScale.scale(NEAR_PX);
    return wires.reversed().stream()
        .filter(each -> new BasicStroke(2 * near).createStrokedShape(each.curve()).contains(point))
        .findFirst();
  }

  private static CubicCurve2D between(Point from, Point to) {
    double bend = Math.max(UIScale.scale(30f), Math.abs(to.x - from.x) / 2.0);
    double towards = to.x >= from.x ? bend : -bend;
    return new CubicCurve2D.Double(
        from.x, from.y, from.x + towards, from.y, to.x - towards, to.y, to.x, to.y);
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    Graphics2D pen = (Graphics2D) graphics.create();
    pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    pen.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    pen.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    wires.stream().filter(each -> !each.chosen()).forEach(each -> draw(pen, each));
    wires.stream().filter(Wire::chosen).forEach(each -> draw(pen, each));
    loose.ifPresent(each -> draw(pen, each));
    pen.dispose();
  }

  private static void draw(Graphics2D pen, Wire wire) {
    if (wire.chosen()) {
      pen.setColor(Palette.tint(Palette.accent(), 0.5));
      pen.setStroke(stroke(CHOSEN_PX + HIGH_PX, false));
      pen.draw(wire.curve());
    }
    Color color = wire.high() ? Palette.ok() : wire.chosen() ? Palette.accent() : Palette.quiet();
    pen.setColor(wire.away() ? Palette.tint(color, 0.5) : color);
    pen.setStroke(stroke(wire.high() ? HIGH_PX : LOW_PX, wire.port().fixed()));
    pen.draw(wire.curve());
  }

  private static BasicStroke stroke(float px, boolean broken) {
    float[] dashes = {UIScale.scale(5f), UIScale.scale(4f)};
    return new BasicStroke(
        UIScale.scale(px),
        BasicStroke.CAP_ROUND,
        BasicStroke.JOIN_ROUND,
        1,
        broken ? dashes : null,
        0);
  }

  private void draw(Graphics2D pen, Loose drawn) {
    pen.setColor(drawn.refused() ? Palette.error() : Palette.accent());
    pen.setStroke(stroke(HIGH_PX, drawn.refused()));
    pen.draw(between(drawn.from(), drawn.pointer()));
    if (!drawn.words().isEmpty()) {
      say(pen, drawn);
    }
  }

  /** What is said at the pointer, broken into lines that have room. */
  private void say(Graphics2D pen, Loose drawn) {
    FontMetrics metrics = pen.getFontMetrics();
    List<String> lines = lines(drawn.words(), metrics, Math.max(1, getWidth() / 2));
    int em = pen.getFont().getSize();
    double wide = em + lines.stream().mapToInt(metrics::stringWidth).max().orElse(0);
    double high = lines.size() * metrics.getHeight() + em / 2.0;
    double x = Math.clamp(drawn.pointer().x + 1.2 * em, 0, Math.max(0, getWidth() - wide));
    double y = Math.clamp(drawn.pointer().y + 1.2 * em, 0, Math.max(0, getHeight() - high));
    pen.setColor(Palette.card());
    pen.fill(new RoundRectangle2D.Double(x, y, wide, high, em / 2.0, em / 2.0));
    pen.setStroke(new BasicStroke(1));
    pen.setColor(drawn.refused() ? Palette.error() : Palette.line());
    pen.draw(new RoundRectangle2D.Double(x, y, wide, high, em / 2.0, em / 2.0));
    pen.setColor(drawn.refused() ? Palette.error() : getForeground());
    double base = y + em / 4.0 + metrics.getAscent();
    for (String line : lines) {
      pen.drawString(line, (float) (x + em / 2.0), (float) base);
      base += metrics.getHeight();
    }
  }

  private static List<String> lines(String words, FontMetrics metrics, int width) {
    List<String> lines = new ArrayList<>();
    StringBuilder line = new StringBuilder();
    for (String word : words.split(" ", -1)) {
      if (!line.isEmpty() && metrics.stringWidth(line + " " + word) > width) {
        lines.add(line.toString());
        line.setLength(0);
      }
      line.append(line.isEmpty() ? "" : " ").append(word);
    }
    lines.add(line.toString());
    return lines;
  }
}
