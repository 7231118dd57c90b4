package org.pendant.desktop.program.form;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.util.List;
import org.pendant.kit.theme.Palette;
import org.pendant.project.program.Pattern;

/** Sketch painter: draws frames, directions and patterns, seen from above at an angle. */
final class SketchPainter {
  /** More dots in a row than this are not drawn: they would touch. */
  private static final int MOST = 12;

  /** How far below the middle the lowest layer of a box is drawn: with its numbers it has room. */
  private static final double BOTTOM = -0.36;

  private static final List<String> AXES = List.of("X", "Y", "Z");

  private final Graphics2D pen;
  private final double middleX;
  private final double middleY;
  private final double size;

  SketchPainter(Graphics2D pen, int width, int height) {
    this.pen = pen;
    middleX = width / 2.0;
    middleY = height / 2.0;
    size = Math.min(width * 0.42, height * 0.5);
  }

  private static float scaled(double pixels) {
    return UIScale.scale((float) pixels);
  }

  /** Where a point is drawn; a length of 1 is about half of the picture's height. */
  private Point2D at(double x, double y, double z) {
    return new Point2D.Double(
        middleX + size * (0.80 * y - 0.55 * x), middleY + size * (0.40 * x + 0.28 * y - 0.85 * z));
  }

  private void line(Point2D from, Point2D to, Color color, double width) {
    pen.setColor(color);
    pen.setStroke(new BasicStroke(scaled(width), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    pen.draw(new Line2D.Double(from, to));
  }

  private void arrow(Point2D from, Point2D to, Color color, double width) {
    line(from, to, color, width);
    double length = from.distance(to);
    double head = scaled(4 + 2 * width);
    if (length < head / 2) {
      dot(to, color, 3);
      return;
    }
    double ux = (to.getX() - from.getX()) / length;
    double uy = (to.getY() - from.getY()) / length;
    Path2D tip = new Path2D.Double();
    tip.moveTo(to.getX() + ux * head / 2, to.getY() + uy * head / 2);
    tip.lineTo(
        to.getX() - ux * head / 2 - uy * head / 2, to.getY() - uy * head / 2 + ux * head / 2);
    tip.lineTo(
        to.getX() - ux * head / 2 + uy * head / 2, to.getY() - uy * head / 2 - ux * head / 2);
    tip.closePath();
    pen.fill(tip);
  }

  private void dot(Point2D at, Color color, double radius) {
    pen.setColor(color);
    double r = scaled(radius);
    pen.fill(new Ellipse2D.Double(at.getX() - r, at.getY() - r, 2 * r, 2 * r));
  }

  private void text(String text, Point2D at, double dx, double dy, Color color) {
    pen.setColor(color);
    float width = pen.getFontMetrics().stringWidth(text);
    float ascent = pen.getFontMetrics().getAscent();
    pen.drawString(
        text,
        (float) at.getX() + scaled(dx) - width / 2,
        (float) at.getY() + scaled(dy) + ascent / 2.5f);
  }

  private static Color axis(int index) {
    return switch (index) {
      case 0 -> Palette.error();
      case 1 -> Palette.ok();
      default -> Palette.accent();
    };
  }

  private Point2D along(int axis, double length) {
    return at(axis == 0 ? length : 0, axis == 1 ? length : 0, axis == 2 ? length : 0);
  }

  private void frame(double length) {
    for (int i = 0; i < 3; i++) {
      arrow(at(0, 0, 0), along(i, length), axis(i), 1.2);
      text(AXES.get(i), along(i, length + 0.22), 0, 0, axis(i));
    }
  }

  void direction(Sketch.Arrow arrow) {
    frame(0.6);
    vector(at(0, 0, 0), arrow.x(), arrow.y(), arrow.z());
  }

  private void vector(Point2D from, double x, double y, double z) {
    double length = Math.sqrt(x * x + y * y + z * z);
    if (length < 1e-9) {
      dot(from, Palette.warning(), 4);
      return;
    }
    Point2D end = at(x / length, y / length, z / length);
    Point2D to =
        new Point2D.Double(
            from.getX() + 0.95 * (end.getX() - middleX),
            from.getY() + 0.95 * (end.getY() - middleY));
    arrow(from, to, Palette.warning(), 3);
  }

  void axes(Sketch.Axes axes) {
    for (int i = 0; i < 3; i++) {
      boolean free = axes.compliant().get(i);
      boolean turns = axes.compliant().get(i + 3);
      double force = axes.wrench().get(i);
      arrow(at(0, 0, 0), along(i, 0.8), free ? axis(i) : Palette.quiet(), free ? 3 : 1);
      text(AXES.get(i), along(i, 1.04), 0, 0, free ? axis(i) : Palette.quiet());
      if (turns) {
        ring(i, axis(i));
      }
      if (free && force != 0) {
        double begin = force > 0 ? 0.15 : 0.6;
        double end = force > 0 ? 0.6 : 0.15;
        Point2D shift = new Point2D.Double(scaled(7), scaled(7));
        arrow(moved(along(i, begin), shift), moved(along(i, end), shift), Palette.warning(), 2);
      }
    }
  }

  private static Point2D moved(Point2D point, Point2D by) {
    return new Point2D.Double(point.getX() + by.getX(), point.getY() + by.getY());
  }

  /** A ring about an axis: it turns. */
  private void ring(int axis, Color color) {
    Path2D ring = new Path2D.Double();
    for (int i = 0; i <= 24; i++) {
      double angle = i * Math.PI / 12;
      double a = 0.18 * Math.cos(angle);
      double b = 0.18 * Math.sin(angle);
      Point2D point =
          switch (axis) {
            case 0 -> at(0.5, a, b);
            case 1 -> at(a, 0.5, b);
            default -> at(a, b, 0.5);
          };
      if (i == 0) {
        ring.moveTo(point.getX(), point.getY());
      } else {
        ring.lineTo(point.getX(), point.getY());
      }
    }
    pen.setColor(color);
    pen.setStroke(new BasicStroke(scaled(1.5)));
    pen.draw(ring);
  }

  void stack(Sketch.Stack stack) {
    for (int i = 0; i < 4; i++) {
      plate(-0.7 + 0.18 * i, !stack.destack() && i == 3);
    }
    double length =
        Math.sqrt(stack.x() * stack.x() + stack.y() * stack.y() + stack.z() * stack.z());
    if (length < 1e-9) {
      return;
    }
    double x = stack.x() / length;
    double y = stack.y() / length;
    double z = stack.z() / length;
    Point2D end = at(0, 0, -0.15);
    Point2D start = at(-0.95 * x, -0.95 * y, -0.15 - 0.95 * z);
    arrow(start, end, Palette.warning(), 3);
    dot(start, Palette.accent(), 3.5);
    text(FormTexts.text("seekStart"), start, 26, 0, Palette.quiet());
  }

  private void plate(double z, boolean missing) {
    Path2D plate = new Path2D.Double();
    double side = 0.55;
    Point2D first = at(-side, -side, z);
    plate.moveTo(first.getX(), first.getY());
    for (int[] corner : new int[][] {{1, -1}, {1, 1}, {-1, 1}}) {
      Point2D next = at(side * corner[0], side * corner[1], z);
      plate.lineTo(next.getX(), next.getY());
    }
    plate.closePath();
    pen.setStroke(
        missing
            ? new BasicStroke(
                scaled(1.2),
                BasicStroke.CAP_BUTT,
                BasicStroke.JOIN_ROUND,
                1,
                new float[] {scaled(4), scaled(3)},
                0)
            : new BasicStroke(scaled(1.2)));
    if (!missing) {
      pen.setColor(Palette.tint(Palette.accent(), 0.2));
      pen.fill(plate);
    }
    pen.setColor(Palette.accent());
    pen.draw(plate);
  }

  void places(Pattern pattern) {
    switch (pattern) {
      case Pattern.Line line -> {
        line(at(0, -1, 0), at(0, 1, 0), Palette.quiet(), 1);
        row(line.count(), 0, 0);
        corner("1", at(0, -1, 0), -12);
        corner("2", at(0, 1, 0), 12);
      }
      case Pattern.Square square -> {
        layer(square.columns(), square.rows(), 0);
        corners(0, 1);
      }
      case Pattern.Box box -> {
        int layers = Math.clamp(box.layers(), 1, MOST);
        for (int i = 0; i < layers; i++) {
          layer(
              box.columns(), box.rows(), layers == 1 ? 0 : BOTTOM - 2 * BOTTOM * i / (layers - 1));
        }
        corners(layers == 1 ? 0 : BOTTOM, 1);
        if (layers > 1) {
          corners(-BOTTOM, 1 + 4);
        }
      }
      case Pattern.Places places -> {
        int count = Math.min(places.places().size(), MOST);
        for (int i = 0; i < count; i++) {
          double along = count == 1 ? 0 : -0.95 + 1.9 * i / (count - 1);
          Point2D at = at(0.35 * Math.sin(2.3 * i), along, 0.25 * Math.cos(1.7 * i));
          corner(Integer.toString(i + 1), at, 11);
        }
      }
    }
  }

  private void row(int count, double x, double z) {
    int shown = Math.clamp(count, 1, MOST);
    for (int i = 0; i < shown; i++) {
      dot(at(x, shown == 1 ? -1 : -1 + 2.0 * i / (shown - 1), z), Palette.accent(), 2.5);
    }
  }

  private void layer(int columns, int rows, double z) {
    int shown = Math.clamp(rows, 1, MOST);
    for (int i = 0; i < shown; i++) {
      double x = shown == 1 ? -0.6 : -0.6 + 1.2 * i / (shown - 1);
      line(at(x, -1, z), at(x, 1, z), Palette.line(), 1);
      row(columns, x, z);
    }
  }

  private void corners(double z, int first) {
    corner(Integer.toString(first), at(-0.6, -1, z), -12);
    corner(Integer.toString(first + 1), at(-0.6, 1, z), 12);
    corner(Integer.toString(first + 2), at(0.6, -1, z), -12);
    corner(Integer.toString(first + 3), at(0.6, 1, z), 12);
  }

  private void corner(String name, Point2D at, double dx) {
    dot(at, Palette.warning(), 4);
    text(name, at, dx, 0, Palette.quiet());
  }
}
