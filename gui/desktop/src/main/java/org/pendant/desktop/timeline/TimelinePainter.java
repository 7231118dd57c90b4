package org.pendant.desktop.timeline;

import static org.pendant.desktop.timeline.TimelineTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Locale;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.ShownMeasure;
import org.pendant.desktop.unit.TimeStep;
import org.pendant.kit.form.Measure;
import org.pendant.kit.theme.Palette;
import org.pendant.recording.ColumnTrace;
import org.pendant.recording.RecordingMark;

/** Timeline painter: draws a timeline: names at the left, time above, a row for each track. */
final class TimelinePainter {
  /** What there may be to see, from above. */
  private enum Row {
    PROGRAM(text("program"), 1.35),
    MARKS(text("marks"), 1.2),
    INPUTS(text("inputs"), 1),
    OUTPUTS(text("outputs"), 1),
    NEAREST(text("nearest"), 1.4),
    SPEED(text("tcpSpeed"), 2.4);

    private final String title;

    /** In heights of a line of text. */
    private final double height;

    Row(String title, double height) {
      this.title = title;
      this.height = height;
    }
  }

  private static final List<Row> ALL = List.of(Row.values());

  /** Where nobody knows how near the arm is to anything. */
  private static final List<Row> WITHOUT_NEAREST =
      ALL.stream().filter(row -> row != Row.NEAREST).toList();

  /** Height of the axis in the same. */
  private static final double AXIS = 1.5;

  /** So far rows become lower where there is little room. */
  private static final double SMALLEST = 0.8;

  /** At this speed the curve is as high as its row, m/s, unless something was faster. */
  private static final double MIN_TOP_M_PER_S = 0.25;

  /** From this use of a margin on it is told as an error. */
  private static final double HIGH = 0.8;

  private List<Row> rows = WITHOUT_NEAREST;
  private int left = UIScale.scale(84);
  private double marksTop;
  private double marksBottom;

  /** Where time begins, in pixels. */
  int left() {
    return left;
  }

  /** Whether a height is that of the row of marks. */
  boolean onMarks(int y) {
    return y >= marksTop && y <= marksBottom;
  }

  int plotWidth(int width) {
    return width - left - UIScale.scale(12);
  }

  /** Has a row for each track that there is; answers whether there are others than before. */
  boolean provide(Tracks tracks) {
    List<Row> before = rows;
    rows = tracks.nearestM().isPresent() ? ALL : WITHOUT_NEAREST;
    return !rows.equals(before);
  }

  /** The height that all rows need. */
  int height(FontMetrics metrics) {
    return height(metrics, rest() + rows.getLast().height);
  }

  /** The height below which names and rows would lie on each other. */
  int leastHeight(FontMetrics metrics) {
    return height(metrics, SMALLEST * (rest() + 1));
  }

  private int height(FontMetrics metrics, double lines) {
    return (int) Math.ceil((AXIS + lines) * metrics.getHeight()) + (rows.size() + 1) * gap();
  }

  /** The lines of all rows but the last. */
  private double rest() {
    return rows.subList(0, rows.size() - 1).stream().mapToDouble(row -> row.height).sum();
  }

  static int gap() {
    return UIScale.scale(4);
  }

  /**
   * How people look at it.
   *
   * @param form in which units they read
   * @param focused whether it has the keyboard
   */
  record Looking(LookBack at, PoseForm form, boolean focused) {}

  void paint(
      Graphics2D pen,
      Dimension size,
      Tracks tracks,
      List<ClientMark> clients,
      List<Pin> pins,
      Looking looking) {
    LookBack at = looking.at();
    pen.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    pen.setColor(Palette.card());
    pen.fillRect(0, 0, size.width, size.height);
    FontMetrics metrics = pen.getFontMetrics();
    left =
        2 * gap()
            + rows.stream().map(row -> row.title).mapToInt(metrics::stringWidth).max().orElse(0)
            + gap();
    int width = plotWidth(size.width);
    if (width < 1) {
      return;
    }
    Sheet sheet = new Sheet(pen, at.range(), left, width, metrics, pen.getClip(), looking.form());
    double y = axis(sheet, size.height, at);
    double[] heights = heights(size.height - y, metrics.getHeight());
    for (int i = 0; i < rows.size(); i++) {
      Row row = rows.get(i);
      double height = heights[i];
      label(sheet, row.title, y, height);
      pen.clipRect(left, 0, width + 1, size.height);
      row(sheet, row, tracks, y, height);
      if (row == Row.MARKS) {
        marksTop = y;
        marksBottom = y + height;
        clients(sheet, clients, y, height);
        pins.forEach(pin -> pin(sheet, pin, marksTop, marksBottom - marksTop));
      }
      pen.setClip(sheet.clip);
      y += height + gap();
    }
    cursor(sheet, size, at, looking.focused());
  }

  /** The last row takes what is left; where there is little, all get less. */
  double[] heights(double room, int lineHeight) {
    double[] heights = new double[rows.size()];
    double gaps = (double) rows.size() * gap();
    double rest = rest() * lineHeight;
    double scale = Math.clamp((room - gaps) / (rest + lineHeight), SMALLEST, 1);
    for (int i = 0; i < heights.length - 1; i++) {
      heights[i] = scale * rows.get(i).height * lineHeight;
    }
    heights[heights.length - 1] = Math.max(scale * lineHeight, room - gaps - scale * rest);
    return heights;
  }

  /**
   * Where things are drawn.
   *
   * @param clip what of it is to be painted
   * @param form in which units people read what is written
   */
  record Sheet(
      Graphics2D pen,
      TimeRange range,
      int left,
      int width,
      FontMetrics metrics,
      Shape clip,
      PoseForm form) {
    double x(double timeS) {
      return left + range.share(timeS) * width;
    }

    boolean sees(double fromS, double toS) {
      return toS >= range.fromS() && fromS <= range.toS();
    }
  }

  private static void label(Sheet sheet, String text, double y, double height) {
    sheet.pen.setColor(Palette.quiet());
    double base = y + (height + sheet.metrics.getAscent() - sheet.metrics.getDescent()) / 2;
    sheet.pen.drawString(text, 2 * gap(), (float) base);
  }

  private static double axis(Sheet sheet, int height, LookBack at) {
    Graphics2D pen = sheet.pen;
    double unit =
        TimeStep.atLeast(
            sheet.range.widthS() * sheet.metrics.stringWidth("0000.000 s  ") / sheet.width);
    double bottom = AXIS * sheet.metrics.getHeight();
    // What is not held any more, or has not come yet, is dimmer.
    double fromX = Math.max(sheet.left, sheet.x(at.recording().firstS()));
    double toX = Math.min(sheet.left + (double) sheet.width, sheet.x(at.recording().lastS()));
    pen.setColor(Palette.tint(Palette.quiet(), 0.08));
    pen.fill(new Rectangle2D.Double(sheet.left, bottom, sheet.width, height - bottom - gap()));
    if (toX > fromX) {
      pen.setColor(Palette.card());
      pen.fill(new Rectangle2D.Double(fromX, bottom, toX - fromX, height - bottom - gap()));
    }
    Rectangle2D flag = flag(sheet, at);
    int decimals = unit >= 1 ? 0 : unit >= 0.1 ? 1 : unit >= 0.01 ? 2 : 3;
    for (double i = Math.ceil(sheet.range.fromS() / unit); i * unit <= sheet.range.toS(); i++) {
      double timeS = i * unit;
      double x = sheet.x(timeS);
      pen.setColor(Palette.line());
      pen.draw(new Line2D.Double(x, bottom - gap(), x, height - (double) gap()));
      String text = String.format(Locale.ROOT, "%." + decimals + "f s", Math.max(0, timeS));
      double textWidth = sheet.metrics.stringWidth(text);
      double textX = Math.min(x + gap() / 2.0, sheet.left + sheet.width - textWidth);
      if (timeS > -unit / 2 && !flag.intersects(textX - gap(), 0, textWidth + 2 * gap(), 1)) {
        pen.setColor(Palette.quiet());
        pen.drawString(text, (float) textX, sheet.metrics.getAscent() + gap() / 2f);
      }
    }
    return bottom + gap();
  }

  private static void row(Sheet sheet, Row row, Tracks tracks, double y, double height) {
    switch (row) {
      case PROGRAM -> programs(sheet, tracks, y, height);
      case MARKS -> marks(sheet, tracks, y, height);
      case INPUTS -> edges(sheet, tracks.inputs(), Palette.series(0), y, height);
      case OUTPUTS -> edges(sheet, tracks.outputs(), Palette.series(1), y, height);
      case NEAREST -> NearestRow.paint(sheet, tracks, y, height);
      case SPEED -> tracks.speedMPerS().ifPresent(speed -> speed(sheet, speed, y, height));
    }
  }

  private static void programs(Sheet sheet, Tracks tracks, double y, double height) {
    for (Tracks.Run run : tracks.runs()) {
      if (sheet.sees(run.fromS(), run.toS())) {
        Color color = run.failed() ? Palette.error() : Palette.ok();
        Rectangle2D bar = bar(sheet, run.fromS(), run.toS(), y, height);
        sheet.pen.setColor(Palette.tint(color, 0.25));
        sheet.pen.fill(bar);
        sheet.pen.setColor(color);
        sheet.pen.draw(bar);
      }
    }
    for (Tracks.Bar ramp : tracks.startRamps()) {
      sheet.pen.setColor(Palette.tint(Palette.ok(), 0.5));
      sheet.pen.fill(wedge(bar(sheet, ramp.fromS(), ramp.toS(), y, height)));
    }
    for (Tracks.Bar pause : tracks.pauses()) {
      sheet.pen.setColor(Palette.tint(Palette.warning(), 0.5));
      sheet.pen.fill(bar(sheet, pause.fromS(), pause.toS(), y + 1, height - 2));
    }
    for (Tracks.Run run : tracks.runs()) {
      if (sheet.sees(run.fromS(), run.toS())) {
        name(sheet, run, y, height);
      }
    }
  }

  /** The name of a program, as far as there is room. */
  private static void name(Sheet sheet, Tracks.Run run, double y, double height) {
    double from = Math.max(sheet.left, sheet.x(run.fromS())) + gap();
    double room = Math.min(sheet.left + (double) sheet.width, sheet.x(run.toS())) - gap() - from;
    String text = run.name();
    while (text.length() > 1 && sheet.metrics.stringWidth(text + "\u2026") > room) {
      text = text.substring(0, text.length() - 1);
    }
    if (text.length() < 2 && !text.equals(run.name())) {
      return;
    }
    String shown = text.equals(run.name()) ? text : text + "\u2026";
    if (sheet.metrics.stringWidth(shown) <= room) {
      sheet.pen.setColor(run.failed() ? Palette.error() : Palette.ok());
      double base = y + (height + sheet.metrics.getAscent() - sheet.metrics.getDescent()) / 2;
      sheet.pen.drawString(shown, (float) from, (float) base);
    }
  }

  private static Rectangle2D bar(Sheet sheet, double fromS, double toS, double y, double height) {
    double from = Math.max(sheet.left - 2.0, sheet.x(fromS));
    double to = Math.min(sheet.left + sheet.width + 2.0, sheet.x(toS));
    return new Rectangle2D.Double(from, y, Math.max(1, to - from), height);
  }

  /** The part of a box below the line from its left bottom to its right top. */
  private static Path2D wedge(Rectangle2D box) {
    Path2D shape = new Path2D.Double();
    shape.moveTo(box.getMinX(), box.getMaxY());
    shape.lineTo(box.getMaxX(), box.getMinY());
    shape.lineTo(box.getMaxX(), box.getMaxY());
    shape.closePath();
    return shape;
  }

  private static void marks(Sheet sheet, Tracks tracks, double y, double height) {
    for (Tracks.Warning warning : tracks.warnings()) {
      if (sheet.sees(warning.timeS(), warning.timeS())) {
        diamond(sheet, warning.timeS(), y, height, Palette.warning());
      }
    }
    for (RecordingMark mark : tracks.marks()) {
      if (!sheet.sees(mark.timeS(), mark.timeS())) {
        continue;
      }
      switch (mark.kind()) {
        case PROGRAM_STARTED, PROGRAM_ENDED -> {}
        case LABEL -> tick(sheet, mark.timeS(), y, height, Palette.quiet());
        case MESSAGE -> diamond(sheet, mark.timeS(), y, height, Palette.accent());
        case ERROR, PROGRAM_FAILED -> diamond(sheet, mark.timeS(), y, height, Palette.error());
        case PROTECTIVE_STOP, SAFETY_STOP -> stop(sheet, mark.timeS(), y, height);
      }
    }
  }

  /** Triangles that come from above, as what clients send comes from outside; one in a pixel. */
  private static void clients(Sheet sheet, List<ClientMark> marks, double y, double height) {
    double half = height * 0.22;
    double last = Double.NEGATIVE_INFINITY;
    sheet.pen.setColor(Palette.series(3));
    for (ClientMark mark : marks) {
      double x = sheet.x(mark.timeS());
      if (sheet.sees(mark.timeS(), mark.timeS()) && x - last >= 1) {
        last = x;
        Path2D shape = new Path2D.Double();
        shape.moveTo(x - half, y);
        shape.lineTo(x + half, y);
        shape.lineTo(x, y + height * 0.5);
        shape.closePath();
        sheet.pen.fill(shape);
      }
    }
  }

  /** A drop upside down, whose point is at the moment; the warmer the nearer it was. */
  private static void pin(Sheet sheet, Pin pin, double y, double height) {
    if (!sheet.sees(pin.timeS(), pin.timeS())) {
      return;
    }
    double x = sheet.x(pin.timeS());
    double r = height * 0.3;
    double middle = y + r;
    Path2D shape = new Path2D.Double(new Arc2D.Double(x - r, y, 2 * r, 2 * r, -30, 240, 0));
    shape.lineTo(x, y + height);
    shape.closePath();
    Color color =
        pin.used() >= HIGH ? Palette.error() : pin.used() > 0 ? Palette.warning() : Palette.quiet();
    sheet.pen.setColor(color);
    sheet.pen.fill(shape);
    sheet.pen.setColor(Palette.card());
    sheet.pen.fill(new Ellipse2D.Double(x - r / 3, middle - r / 3, 2 * r / 3, 2 * r / 3));
  }

  private static void tick(Sheet sheet, double timeS, double y, double height, Color color) {
    double x = sheet.x(timeS);
    sheet.pen.setColor(color);
    sheet.pen.draw(new Line2D.Double(x, y + height * 0.55, x, y + height));
  }

  private static void diamond(Sheet sheet, double timeS, double y, double height, Color color) {
    double x = sheet.x(timeS);
    double r = height * 0.32;
    double middle = y + height / 2;
    Path2D shape = new Path2D.Double();
    shape.moveTo(x, middle - r);
    shape.lineTo(x + r, middle);
    shape.lineTo(x, middle + r);
    shape.lineTo(x - r, middle);
    shape.closePath();
    sheet.pen.setColor(color);
    sheet.pen.fill(shape);
  }

  /** An octagon, as on the road. */
  private static void stop(Sheet sheet, double timeS, double y, double height) {
    double x = sheet.x(timeS);
    double r = height * 0.48;
    Path2D shape = new Path2D.Double();
    for (int i = 0; i < 8; i++) {
      double angle = Math.PI / 8 + i * Math.PI / 4;
      double px = x + r * Math.cos(angle);
      double py = y + height / 2 + r * Math.sin(angle);
      if (i == 0) {
        shape.moveTo(px, py);
      } else {
        shape.lineTo(px, py);
      }
    }
    shape.closePath();
    sheet.pen.setColor(Palette.error());
    sheet.pen.fill(shape);
  }

  private static void edges(
      Sheet sheet, List<Tracks.Bar> edges, Color color, double y, double height) {
    sheet.pen.setColor(Palette.line());
    double base = y + height;
    sheet.pen.draw(new Line2D.Double(sheet.left, base, sheet.left + sheet.width, base));
    sheet.pen.setColor(color);
    for (Tracks.Bar each : edges) {
      if (sheet.sees(each.fromS(), each.toS())) {
        sheet.pen.fill(bar(sheet, each.fromS(), each.toS(), y, height));
      }
    }
  }

  private static void speed(Sheet sheet, ColumnTrace speed, double y, double height) {
    double top = MIN_TOP_M_PER_S;
    for (int i = 0; i < speed.size(); i++) {
      top = speed.highest(i) > top ? speed.highest(i) : top;
    }
    Path2D curve = new Path2D.Double();
    boolean drawing = false;
    for (int i = 0; i < speed.size(); i++) {
      if (Double.isNaN(speed.highest(i))) {
        drawing = false;
        continue;
      }
      double x = sheet.x(speed.timeS(i));
      double at = y + height * (1 - speed.highest(i) / top);
      if (drawing) {
        curve.lineTo(x, at);
      } else {
        curve.moveTo(x, at);
      }
      drawing = true;
    }
    sheet.pen.setColor(Palette.series(2));
    sheet.pen.setStroke(new BasicStroke(UIScale.scale(1.3f)));
    sheet.pen.draw(curve);
    sheet.pen.setStroke(new BasicStroke(1));
    sheet.pen.setColor(Palette.quiet());
    Measure measure = ShownMeasure.of(Measure.MILLIMETRE_PER_S, sheet.form);
    String text = measure.brief(top) + " " + measure.symbol();
    double base = y + (height + sheet.metrics.getAscent() - sheet.metrics.getDescent()) / 2;
    // Below the name of the row, where there is room.
    if (height > 2 * sheet.metrics.getHeight()) {
      sheet.pen.setClip(sheet.clip);
      sheet.pen.drawString(text, 2 * gap(), (float) (base + sheet.metrics.getHeight()));
    }
  }

  private static void cursor(Sheet sheet, Dimension size, LookBack at, boolean focused) {
    double timeS = at.timeS().orElse(at.recording().lastS());
    if (!sheet.sees(timeS, timeS)) {
      return;
    }
    double x = sheet.x(timeS);
    Color color = at.back() ? Palette.accent() : Palette.quiet();
    sheet.pen.setColor(color);
    sheet.pen.setStroke(new BasicStroke(UIScale.scale(focused ? 2f : 1.5f)));
    sheet.pen.draw(new Line2D.Double(x, 0, x, size.height));
    if (at.back()) {
      Rectangle2D flag = flag(sheet, at);
      sheet.pen.fill(flag);
      sheet.pen.setColor(Palette.card());
      sheet.pen.drawString(
          LookBack.text(timeS), (float) flag.getX() + gap(), sheet.metrics.getAscent() + 1f);
    }
  }

  /** Where the moment that people look at is written; empty while that is now. */
  private static Rectangle2D flag(Sheet sheet, LookBack at) {
    double timeS = at.timeS().orElse(Double.NaN);
    if (!at.back() || !sheet.sees(timeS, timeS)) {
      return new Rectangle2D.Double();
    }
    double width = sheet.metrics.stringWidth(LookBack.text(timeS)) + 2.0 * gap();
    double right = sheet.left + sheet.width + 3.0 * gap();
    double from =
        Math.clamp(sheet.x(timeS) - width / 2, sheet.left, Math.max(sheet.left, right - width));
    return new Rectangle2D.Double(from, 0, width, sheet.metrics.getHeight() + 2.0);
  }
}
