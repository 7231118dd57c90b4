package org.pendant.desktop.program;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import javax.swing.Icon;
import org.pendant.kit.theme.Palette;
import org.pendant.project.program.NodeKind;
import org.pendant.project.program.Step;

/** A small drawing for each kind of node, in a square of 16, in the colour of its family. */
final class StepIcon implements Icon {
  private static final int SIDE = 16;

  private final List<Shape> strokes = new ArrayList<>();
  private final List<Shape> fills = new ArrayList<>();
  private final Supplier<Color> color;

  private StepIcon(Supplier<Color> color) {
    this.color = color;
  }

  static StepIcon of(Step step) {
    return of(NodeKind.of(step));
  }

  static StepIcon of(NodeKind kind) {
    return switch (kind) {
      case MOVE_JOINT -> move().curve(2, 13, 4, 3, 14, 3).dot(2, 13).dot(14, 3);
      case MOVE_LINEAR -> move().line(2, 13, 14, 3).dot(2, 13).dot(14, 3);
      case MOVE_PROCESS -> move().line(1, 12, 5, 4).curve(5, 4, 7, 1, 9, 5).line(9, 5, 14, 13);
      case WAYPOINT -> move().circle(8, 6, 3.5).line(8, 9.5, 8, 14.5);
      case DIRECTION -> move().line(2, 8, 13, 8).line(9.5, 4.5, 13, 8, 9.5, 11.5);
      case UNTIL -> move().line(2, 8, 10, 8).line(7, 5, 10, 8, 7, 11).line(13, 3, 13, 13);
      case CIRCLE_MOVE -> move().curve(2, 12, 8, -4, 14, 12).dot(2, 12).dot(14, 12).dot(8, 4);
      case HOME -> move().line(2, 8, 8, 2.5, 14, 8).line(4, 7, 4, 13.5, 12, 13.5, 12, 7);
      case WAIT -> action().circle(8, 8, 6).line(8, 4.5, 8, 8, 10.5, 9.5);
      case SET -> action().box(2, 5, 12, 6).disc(11, 8, 2);
      case POPUP -> action().box(2, 3, 12, 8).line(5, 11, 5, 14, 8, 11);
      case HALT ->
          action().polygon(5.5, 2, 10.5, 2, 14, 5.5, 14, 10.5, 10.5, 14, 5.5, 14, 2, 10.5, 2, 5.5);
      case COMMENT -> action().line(3, 4, 13, 4).line(3, 8, 13, 8).line(3, 12, 9, 12);
      case FOLDER -> action().polygon(2, 4, 6.5, 4, 8, 6, 14, 6, 14, 13, 2, 13);
      case LOOP ->
          flow().curve(13, 6, 8, -1, 3, 6).curve(3, 10, 8, 17, 13, 10).line(13, 2, 13, 6, 9.5, 6);
      case CALL, SUB_PROGRAM ->
          flow().box(2, 2, 7, 5).box(7, 9, 7, 5).line(4.5, 7, 4.5, 11.5, 7, 11.5);
      case ASSIGNMENT -> flow().line(3, 6, 13, 6).line(3, 10, 13, 10);
      case OPERATOR_INPUT ->
          flow().line(6.5, 7, 6.5, 4, 11, 4, 11, 8, 8.5, 9, 8.5, 10.5).disc(8.5, 13, 1);
      case IF -> flow().polygon(8, 2, 14, 8, 8, 14, 2, 8);
      case ELSE_IF -> flow().polygon(8, 2, 14, 8, 8, 14, 2, 8).disc(8, 8, 1.5);
      case ELSE -> flow().line(3, 3, 3, 11, 12, 11).line(9, 8, 12, 11, 9, 14);
      case SWITCH ->
          flow()
              .line(2, 8, 6, 8)
              .line(6, 3, 6, 13)
              .line(6, 3, 13, 3)
              .line(6, 8, 13, 8)
              .line(6, 13, 13, 13);
      case CASE, DEFAULT_CASE -> flow().line(2, 8, 12, 8).line(9, 5, 12, 8, 9, 11);
      case SCRIPT_LINE -> action().line(5, 4, 1.5, 8, 5, 12).line(11, 4, 14.5, 8, 11, 12);
      case SCRIPT_FILE ->
          action()
              .polygon(3, 2, 10, 2, 13, 5, 13, 14, 3, 14)
              .line(5.5, 8, 10.5, 8)
              .line(5.5, 11, 10.5, 11);
      case TIMER -> flow().circle(8, 9, 5.2).line(8, 6, 8, 9).line(6, 1.8, 10, 1.8);
      case PALLETIZING ->
          template().box(2, 2, 5, 5).box(9, 2, 5, 5).box(2, 9, 5, 5).box(9, 9, 5, 5);
      case APPROACH -> template().line(8, 2, 8, 9).line(5, 6, 8, 9, 11, 6).line(3, 13, 13, 13);
      case PATTERN_POINT -> template().circle(8, 8, 4).disc(8, 8, 1.5);
      case EXIT -> template().line(8, 9, 8, 2).line(5, 5, 8, 2, 11, 5).line(3, 13, 13, 13);
      case PART_BEFORE, PART_AFTER, PART_SEQUENCE -> template().box(3, 3, 10, 10).line(3, 8, 13, 8);
      case STACK -> template().box(3, 10, 10, 4).box(3, 5.5, 10, 4).line(8, 0.5, 8, 3.5);
      case DESTACK -> template().box(3, 10, 10, 4).box(3, 5.5, 10, 4).line(5.5, 3, 8, 0.5, 10.5, 3);
      case FORCE -> template().line(2, 8, 9, 8).line(6, 5, 9, 8, 6, 11).line(12, 2, 12, 14);
      case SCREWDRIVING ->
          template().line(4, 2, 12, 2).line(8, 2, 8, 14).line(5, 6, 11, 8).line(5, 10, 11, 12);
      case CONVEYOR_TRACKING ->
          template().line(2, 10, 14, 10).disc(4, 13, 1.3).disc(12, 13, 1.3).box(5.5, 4, 5, 5);
      case INITIAL_VALUES ->
          section()
              .line(2, 4, 7, 4)
              .line(2, 8, 7, 8)
              .line(2, 12, 7, 12)
              .line(9, 4, 14, 4)
              .line(9, 8, 14, 8)
              .line(9, 12, 14, 12);
      case BEFORE_START -> section().line(3, 2.5, 3, 13.5).polygon(6, 3, 14, 8, 6, 13);
      case MAIN_PROGRAM -> section().polygon(4, 2, 14, 8, 4, 14);
      case THREAD -> section().curve(4, 2, 12, 8, 4, 14).curve(10, 2, 18, 8, 10, 14);
      case EVENT -> section().polygon(9, 1, 3, 9, 7.5, 9, 6, 15, 13, 6.5, 8.5, 6.5);
      case CONTRIBUTED ->
          foreign().polygon(3, 5, 6.5, 5, 6.5, 2, 9.5, 2, 9.5, 5, 13, 5, 13, 13, 3, 13);
      case UNKNOWN ->
          foreign()
              .box(2.5, 2.5, 11, 11)
              .line(6, 6, 7, 5, 9, 5, 10, 6.5, 8, 8.5, 8, 9.5)
              .disc(8, 11.8, 0.8);
    };
  }

  private static StepIcon move() {
    return new StepIcon(() -> Palette.series(0));
  }

  private static StepIcon action() {
    return new StepIcon(() -> Palette.series(2));
  }

  private static StepIcon flow() {
    return new StepIcon(() -> Palette.series(5));
  }

  private static StepIcon template() {
    return new StepIcon(() -> Palette.series(4));
  }

  private static StepIcon section() {
    return new StepIcon(() -> Palette.series(3));
  }

  private static StepIcon foreign() {
    return new StepIcon(Palette::quiet);
  }

  private StepIcon line(double... xy) {
    Path2D path = new Path2D.Double();
    path.moveTo(xy[0], xy[1]);
    for (int i = 2; i < xy.length; i += 2) {
      path.lineTo(xy[i], xy[i + 1]);
    }
    strokes.add(path);
    return this;
  }

  private StepIcon polygon(double... xy) {
    line(xy);
    ((Path2D) strokes.getLast()).closePath();
    return this;
  }

  private StepIcon curve(double x1, double y1, double cx, double cy, double x2, double y2) {
    Path2D path = new Path2D.Double();
    path.moveTo(x1, y1);
    path.quadTo(cx, cy, x2, y2);
    strokes.add(path);
    return this;
  }

  private StepIcon box(double x, double y, double width, double height) {
    strokes.add(new Rectangle2D.Double(x, y, width, height));
    return this;
  }

  private StepIcon circle(double x, double y, double radius) {
    strokes.add(new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius));
    return this;
  }

  private StepIcon disc(double x, double y, double radius) {
    fills.add(new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius));
    return this;
  }

  private StepIcon dot(double x, double y) {
    return disc(x, y, 1.8);
  }

  /** The colour of its family. */
  Color color() {
    return color.get();
  }

  /** The same in another colour, for what is selected. */
  Icon in(Color wanted) {
    StepIcon other = new StepIcon(() -> wanted);
    other.strokes.addAll(strokes);
    other.fills.addAll(fills);
    return other;
  }

  /** What draws an icon in its own units, from its upper left corner; to be disposed of. */
  static Graphics2D pen(Graphics g, int x, int y, Color color, float width) {
    Graphics2D pen = (Graphics2D) g.create();
    pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    pen.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    pen.setColor(color);
    pen.translate(x, y);
    UIScale.scaleGraphics(pen);
    pen.setStroke(new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    return pen;
  }

  /** Draws it in any colour. */
  void paint(Graphics g, int x, int y, Color wanted) {
    Graphics2D pen = pen(g, x, y, wanted, 1.5f);
    strokes.forEach(pen::draw);
    fills.forEach(pen::fill);
    pen.dispose();
  }

  @Override
  public void paintIcon(Component c, Graphics g, int x, int y) {
    paint(g, x, y, c.isEnabled() ? color() : Palette.quiet());
  }

  @Override
  public int getIconWidth() {
    return UIScale.scale(SIDE);
  }

  @Override
  public int getIconHeight() {
    return UIScale.scale(SIDE);
  }
}
