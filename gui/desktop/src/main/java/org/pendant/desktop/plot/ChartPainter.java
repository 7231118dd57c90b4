package org.pendant.desktop.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.Stroke;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.List;
import org.pendant.desktop.workbench.ScreenUnit;
import org.pendant.kit.theme.Palette;

/** Chart painter: paints one chart: grid, axis of values, lines and cursors. */
final class ChartPainter {
  private static final Stroke LINE =
      new BasicStroke(1.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
  private static final Stroke DASHED =
      new BasicStroke(
          1.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND, 1, new float[] {6, 4}, 0);
  private static final Stroke BOLD =
      new BasicStroke(3, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
  private static final Stroke HAIR = new BasicStroke(1);

  /** How many colours there are before lines become dashed. */
  private static final int COLORS = 8;

  /** Lines that go up and down by more than this in every column of pixels become bands. */
  private static final double SMOOTH_PIXELS = 30;

  private final PlotPresenter presenter;
  private final List<Columns> columnsOfTraces = new ArrayList<>();

  ChartPainter(PlotPresenter presenter) {
    this.presenter = presenter;
  }

  /** The stroke of a line of this colour number. */
  static Stroke stroke(int color) {
    return color < COLORS ? LINE : DASHED;
  }

  /** The stroke of the same line in a legend. */
  static Stroke swatch(int color) {
    return color < COLORS ? BOLD : DASHED;
  }

  /** Paints a chart whose lines go into {@code area}; numbers stand left of it. */
  void paint(Graphics2D pen, Chart chart, Rectangle area) {
    if (area.width < 2 || area.height < 2) {
      return;
    }
    pen.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    int most = Math.max(2, area.height / (3 * pen.getFontMetrics().getHeight()));
    pen.setColor(Palette.card());
    pen.fill(area);
    Scale scale = scale(chart, area.width, most);
    paintGrid(pen, scale, chart.unit(), area);
    Graphics2D inside = (Graphics2D) pen.create();
    inside.clipRect(area.x, area.y - 1, area.width, area.height + 2);
    inside.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    for (int i = 0; i < chart.traces().size(); i++) {
      ChartTrace trace = chart.traces().get(i);
      inside.setColor(Palette.series(trace.color()));
      inside.setStroke(stroke(trace.color()));
      paintTrace(inside, trace.quantity(), columnsOfTraces.get(i), scale, area);
    }
    presenter.cursors().ifPresent(cursors -> paintCursors(inside, cursors, area));
    inside.dispose();
  }

  private Scale scale(Chart chart, int width, int most) {
    double low = Double.POSITIVE_INFINITY;
    double high = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < chart.traces().size(); i++) {
      if (columnsOfTraces.size() == i) {
        columnsOfTraces.add(new Columns());
      }
      Columns columns = columnsOfTraces.get(i);
      ChartQuantity quantity = chart.traces().get(i).quantity();
      columns.fill(presenter.history(), quantity, presenter.window(), width);
      for (int x = 0; x < width; x++) {
        if (columns.has(x)) {
          low = Math.min(low, columns.least(x));
          high = Math.max(high, columns.most(x));
        }
      }
    }
    if (chart.traces().stream().allMatch(each -> each.quantity().digital())) {
      return new Scale(-0.15, 1.15, 1);
    }
    return low > high ? Scale.around(0, 1, most) : Scale.around(low, high, most);
  }

  private void paintGrid(Graphics2D pen, Scale scale, String unit, Rectangle area) {
    FontMetrics metrics = pen.getFontMetrics();
    pen.setStroke(HAIR);
    for (double tick : scale.ticks()) {
      int y = y(scale, tick, area);
      pen.setColor(Palette.line());
      pen.drawLine(area.x, y, area.x + area.width, y);
      pen.setColor(Palette.quiet());
      String text = scale.text(tick);
      pen.drawString(text, area.x - 8 - metrics.stringWidth(text), y + metrics.getAscent() / 2 - 1);
    }
    TimeWindow window = presenter.window();
    pen.setColor(Palette.line());
    for (double tick : TimeAxis.scale(window, area.width, metrics).ticks()) {
      int x = area.x + (int) Math.round(window.placeOf(tick) * area.width);
      pen.drawLine(x, area.y, x, area.y + area.height);
    }
    pen.setColor(Palette.quiet());
    if (!unit.isEmpty() && !unit.equals(ScreenUnit.LEVEL)) {
      pen.drawString(unit, area.x + 6, area.y + metrics.getAscent() + 2);
    }
  }

  private static int y(Scale scale, double value, Rectangle area) {
    return area.y + area.height - (int) Math.round(scale.placeOf(value) * area.height);
  }

  private static double exactY(Scale scale, double value, Rectangle area) {
    return area.y + area.height * (1 - scale.placeOf(value));
  }

  private void paintTrace(
      Graphics2D pen, ChartQuantity quantity, Columns columns, Scale scale, Rectangle area) {
    TimeSeries series = presenter.history().of(quantity);
    TimeWindow window = presenter.window();
    long begin = Math.max(series.first(), series.firstAtLeast(window.beginS()) - 1);
    long end = Math.min(series.end(), series.firstAtLeast(window.endS()) + 1);
    if (end - begin <= area.width || quantity.digital()) {
      pen.draw(everySample(quantity, scale, area, begin, end));
    } else if (columns.meanSpan() / (scale.high() - scale.low()) * area.height < SMOOTH_PIXELS) {
      pen.draw(everyColumn(columns, scale, area));
    } else {
      fillColumns(pen, columns, scale, area);
    }
  }

  /** A band from least to most; smooth edges would not be seen and take fifty times as long. */
  private static void fillColumns(Graphics2D pen, Columns columns, Scale scale, Rectangle area) {
    double before = Double.NaN;
    for (int x = 0; x < columns.width(); x++) {
      if (columns.has(x)) {
        boolean first = Double.isNaN(before) || columns.broken(x);
        int top = y(scale, first ? columns.most(x) : Math.max(columns.most(x), before), area);
        int bottom = y(scale, first ? columns.least(x) : Math.min(columns.least(x), before), area);
        pen.fillRect(area.x + x, top, 1, bottom - top + 1);
        before = columns.last(x);
      }
    }
  }

  /** A line through all samples; levels go up and down at once. */
  private Path2D everySample(
      ChartQuantity quantity, Scale scale, Rectangle area, long begin, long end) {
    TimeSeries series = presenter.history().of(quantity);
    TimeWindow window = presenter.window();
    Path2D path = new Path2D.Double();
    boolean drawing = false;
    double before = Double.NaN;
    for (long number = begin; number < end; number++) {
      double value = series.value(quantity, number);
      boolean steady = quantity.digital() && value == before && number < end - 1;
      if (!steady && !Double.isNaN(value)) {
        double x = area.x + window.placeOf(series.timeS(number)) * area.width;
        double y = exactY(scale, value, area);
        if (!drawing) {
          path.moveTo(x, y);
        } else {
          if (quantity.digital() && value != before) {
            path.lineTo(x, exactY(scale, before, area));
          }
          path.lineTo(x, y);
        }
      }
      drawing = !Double.isNaN(value);
      before = value;
    }
    return path;
  }

  /** A line through the first value of every column of pixels, and through peaks within it. */
  private static Path2D everyColumn(Columns columns, Scale scale, Rectangle area) {
    Path2D path = new Path2D.Double();
    boolean drawing = false;
    for (int x = 0; x < columns.width(); x++) {
      if (!columns.has(x)) {
        continue;
      }
      double at = area.x + x + 0.5;
      double first = exactY(scale, columns.first(x), area);
      if (drawing && !columns.broken(x)) {
        path.lineTo(at, first);
      } else {
        path.moveTo(at, first);
      }
      drawing = true;
      if (columns.detour(x) > 0) {
        path.lineTo(at, exactY(scale, columns.least(x), area));
        path.lineTo(at, exactY(scale, columns.most(x), area));
        path.lineTo(at, exactY(scale, columns.last(x), area));
      }
    }
    return path;
  }

  private void paintCursors(Graphics2D pen, Cursors cursors, Rectangle area) {
    Color color = Palette.accent();
    List<Double> times = List.of(cursors.aS(), cursors.bS());
    for (int i = 0; i < times.size(); i++) {
      double x = area.x + presenter.window().placeOf(times.get(i)) * area.width;
      pen.setColor(color);
      pen.setStroke(HAIR);
      pen.draw(new Line2D.Double(x, area.y, x, area.y + area.height));
      String name = i == 0 ? "A" : "B";
      FontMetrics metrics = pen.getFontMetrics();
      int width = metrics.stringWidth(name) + 8;
      int left = (int) Math.round(x) - width / 2;
      pen.fillRoundRect(left, area.y, width, metrics.getHeight(), 6, 6);
      pen.setColor(Palette.card());
      pen.drawString(name, left + 4, area.y + metrics.getAscent());
    }
  }
}
