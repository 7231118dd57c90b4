package org.pendant.kit.theme;

import java.awt.Shape;
import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/** Small drawings in a square of 24 by 24, stroked or filled. */
public final class Glyph {
  public static final Glyph PLAY = Drawing.filled().polygon(7, 4, 20, 12, 7, 20).glyph();

  public static final Glyph PAUSE = Drawing.filled().box(6, 5, 4, 14).box(14, 5, 4, 14).glyph();

  public static final Glyph STOP = Drawing.filled().box(5, 5, 14, 14).glyph();

  public static final Glyph STEP =
      Drawing.filled().polygon(5, 5, 15, 12, 5, 19).box(17, 5, 3, 14).glyph();

  public static final Glyph POWER =
      Drawing.stroked().arc(4, 5, 16, 16, 125, 290).line(12, 2, 12, 11).glyph();

  public static final Glyph RUN =
      Drawing.stroked().circle(12, 12, 9).polygon(10, 8, 16, 12, 10, 16).glyph();

  public static final Glyph PROGRAM =
      Drawing.stroked()
          .line(5, 4, 5, 18, 10, 18)
          .line(5, 11, 10, 11)
          .box(11, 8.5, 9, 5)
          .box(11, 15.5, 9, 5)
          .disc(5, 4, 1.8)
          .glyph();

  public static final Glyph SCRIPT =
      Drawing.stroked()
          .polygon(5, 3, 15, 3, 19, 7, 19, 21, 5, 21)
          .line(8, 10, 16, 10)
          .line(8, 13.5, 16, 13.5)
          .line(8, 17, 13, 17)
          .glyph();

  public static final Glyph MOVE =
      Drawing.stroked()
          .line(12, 3, 12, 21)
          .line(3, 12, 21, 12)
          .line(9.5, 5.5, 12, 3, 14.5, 5.5)
          .line(9.5, 18.5, 12, 21, 14.5, 18.5)
          .line(5.5, 9.5, 3, 12, 5.5, 14.5)
          .line(18.5, 9.5, 21, 12, 18.5, 14.5)
          .glyph();

  public static final Glyph SIGNALS =
      Drawing.stroked()
          .line(3, 8, 21, 8)
          .line(3, 16, 21, 16)
          .disc(15, 8, 3.2)
          .disc(9, 16, 3.2)
          .glyph();

  public static final Glyph INSTALLATION =
      Drawing.stroked()
          .circle(12, 12, 3.2)
          .circle(12, 12, 6.8)
          .line(12, 2.5, 12, 5.2)
          .line(12, 18.8, 12, 21.5)
          .line(2.5, 12, 5.2, 12)
          .line(18.8, 12, 21.5, 12)
          .line(5.3, 5.3, 7.2, 7.2)
          .line(16.8, 16.8, 18.7, 18.7)
          .line(5.3, 18.7, 7.2, 16.8)
          .line(16.8, 7.2, 18.7, 5.3)
          .glyph();

  public static final Glyph LOG =
      Drawing.stroked()
          .line(9, 6, 21, 6)
          .line(9, 12, 21, 12)
          .line(9, 18, 21, 18)
          .disc(4.5, 6, 1.4)
          .disc(4.5, 12, 1.4)
          .disc(4.5, 18, 1.4)
          .glyph();

  public static final Glyph PLOT =
      Drawing.stroked().line(3, 3, 3, 21, 21, 21).line(6, 16, 11, 10, 14, 13, 20, 5).glyph();

  public static final Glyph CLOCK =
      Drawing.stroked().circle(12, 12, 9).line(12, 6, 12, 12, 16, 14).glyph();

  public static final Glyph CLOSE = Drawing.stroked().line(6, 6, 18, 18).line(18, 6, 6, 18).glyph();

  public static final Glyph LEFT = Drawing.stroked().line(15, 5, 8, 12, 15, 19).glyph();

  public static final Glyph RIGHT = Drawing.stroked().line(9, 5, 16, 12, 9, 19).glyph();

  public static final Glyph DOWN = Drawing.stroked().line(5, 9, 12, 16, 19, 9).glyph();

  public static final Glyph UP = Drawing.stroked().line(5, 15, 12, 8, 19, 15).glyph();

  public static final Glyph MORE =
      Drawing.filled().disc(5, 12, 2).disc(12, 12, 2).disc(19, 12, 2).glyph();

  public static final Glyph WARNING =
      Drawing.stroked()
          .polygon(12, 3, 22, 20.5, 2, 20.5)
          .line(12, 9, 12, 14.5)
          .disc(12, 17.4, 1)
          .glyph();

  public static final Glyph ERROR =
      Drawing.stroked()
          .polygon(8, 3, 16, 3, 21, 8, 21, 16, 16, 21, 8, 21, 3, 16, 3, 8)
          .line(12, 7, 12, 13)
          .disc(12, 16.5, 1)
          .glyph();

  public static final Glyph INFO =
      Drawing.stroked().circle(12, 12, 9).line(12, 11, 12, 17).disc(12, 7.6, 1).glyph();

  public static final Glyph QUESTION =
      Drawing.stroked()
          .circle(12, 12, 9)
          .line(
              9.2, 9.6, 9.8, 7.9, 11.2, 7, 12.8, 7, 14.2, 7.9, 14.8, 9.6, 14, 11.2, 12, 12.6, 12,
              14)
          .disc(12, 17, 1)
          .glyph();

  public static final Glyph ROBOT =
      Drawing.stroked()
          .line(5, 21, 15, 21)
          .line(10, 21, 10, 14, 16, 8, 20, 11)
          .disc(10, 14, 2)
          .disc(16, 8, 2)
          .glyph();

  private final List<Shape> strokes;
  private final List<Shape> fills;

  private Glyph(List<Shape> strokes, List<Shape> fills) {
    this.strokes = List.copyOf(strokes);
    this.fills = List.copyOf(fills);
  }

  List<Shape> strokes() {
    return strokes;
  }

  List<Shape> fills() {
    return fills;
  }

  private static final class Drawing {
    private final List<Shape> strokes = new ArrayList<>();
    private final List<Shape> fills = new ArrayList<>();
    private final boolean filled;

    private Drawing(boolean filled) {
      this.filled = filled;
    }

    static Drawing filled() {
      return new Drawing(true);
    }

    static Drawing stroked() {
      return new Drawing(false);
    }

    Glyph glyph() {
      return new Glyph(strokes, fills);
    }

    private Drawing add(Shape shape) {
      (filled ? fills : strokes).add(shape);
      return this;
    }

    Drawing polygon(double... xy) {
      Path2D path = path(xy);
      path.closePath();
      return add(path);
    }

    Drawing line(double... xy) {
      strokes.add(path(xy));
      return this;
    }

    private static Path2D path(double... xy) {
      Path2D path = new Path2D.Double();
      path.moveTo(xy[0], xy[1]);
      for (int i = 2; i < xy.length; i += 2) {
        path.lineTo(xy[i], xy[i + 1]);
      }
      return path;
    }

    Drawing box(double x, double y, double width, double height) {
      return add(new Rectangle2D.Double(x, y, width, height));
    }

    Drawing circle(double x, double y, double radius) {
      return add(new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius));
    }

    Drawing disc(double x, double y, double radius) {
      fills.add(new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius));
      return this;
    }

    Drawing arc(double x, double y, double width, double height, double start, double extent) {
      return add(new Arc2D.Double(x, y, width, height, start, extent, Arc2D.OPEN));
    }
  }
}
