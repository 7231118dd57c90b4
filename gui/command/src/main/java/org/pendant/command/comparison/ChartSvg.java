package org.pendant.command.comparison;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.recording.compare.Difference;
import org.pendant.recording.compare.RunComparison;
import org.pendant.recording.compare.SampledQuantity;
import org.pendant.recording.compare.Samples;

/**
 * Chart: one quantity of a recording and of Pendant's run over time, as an SVG picture with a panel
 * for each of its numbers. The recording is orange, its samples are dots where they are few;
 * Pendant is blue.
 */
public final class ChartSvg {
  private static final int COLUMNS = 3;
  private static final int PANEL_WIDTH = 320;
  private static final int PANEL_HEIGHT = 170;
  private static final int TITLE_HEIGHT = 26;
  private static final int LEFT = 56;
  private static final int RIGHT = 10;
  private static final int TOP = 20;
  private static final int BOTTOM = 24;
  private static final int MAX_DOTS = 150;
  private static final int MAX_POINTS = 600;
  private static final String RECORDED_COLOUR = "#d55e00";
  private static final String PENDANT_COLOUR = "#0072b2";

  /** What can be seen, in pixels. */
  private static final double VISIBLE = 0.4;

  private static final double MARGIN = 0.06;

  private final RunComparison comparison;
  private final StateQuantity quantity;
  private final StringBuilder svg = new StringBuilder();

  /** A point of a line: time and number. */
  private record Point(double timeS, double value) {}

  private ChartSvg(RunComparison comparison, StateQuantity quantity) {
    this.comparison = comparison;
    this.quantity = quantity;
  }

  /** The chart of a quantity that both have. */
  public static String of(RunComparison comparison, StateQuantity quantity) {
    return new ChartSvg(comparison, quantity).draw();
  }

  private String draw() {
    int panels = quantity.size();
    int columns = Math.min(COLUMNS, panels);
    int rows = (panels + columns - 1) / columns;
    int width = columns * PANEL_WIDTH;
    int height = TITLE_HEIGHT + rows * PANEL_HEIGHT;
    add(
        String.format(
            Locale.ROOT,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\""
                + " height=\"%d\" font-family=\"sans-serif\" font-size=\"11\">",
            width,
            height,
            width,
            height));
    add(
        String.format(
            Locale.ROOT, "<rect width=\"%d\" height=\"%d\" fill=\"#ffffff\"/>", width, height));
    add(
        String.format(
            Locale.ROOT,
            "<text x=\"8\" y=\"17\" font-size=\"13\">%s: <tspan fill=\"%s\">recording</tspan>,"
                + " <tspan fill=\"%s\">Pendant</tspan>; time in s</text>",
            MarkupText.of(SampledQuantity.name(quantity)),
            RECORDED_COLOUR,
            PENDANT_COLOUR));
    for (int i = 0; i < panels; i++) {
      panel(i, (i % columns) * PANEL_WIDTH, TITLE_HEIGHT + (i / columns) * PANEL_HEIGHT);
    }
    svg.append("</svg>\n");
    return svg.toString();
  }

  private void panel(int component, int x, int y) {
    Samples recorded = comparison.recorded();
    List<Point> real = points(recorded, component, 0, 0, recorded.rows() - 1);
    Samples pendant = comparison.pendant();
    double shiftS = comparison.shiftS();
    List<Point> ours =
        points(
            pendant,
            component,
            shiftS,
            pendant.rowBefore(recorded.firstS() + shiftS),
            pendant.rowBefore(recorded.lastS() + shiftS));
    double least = Double.POSITIVE_INFINITY;
    double most = Double.NEGATIVE_INFINITY;
    for (List<Point> each : List.of(real, ours)) {
      for (Point point : each) {
        least = Math.min(least, point.value());
        most = Math.max(most, point.value());
      }
    }
    double room = Math.max(MARGIN * (most - least), 1e-9 + 1e-6 * Math.abs(most));
    Frame frame = new Frame(x, y, recorded.firstS(), recorded.lastS(), least - room, most + room);
    String unit = SampledQuantity.unit(quantity, component);
    add(
        String.format(
            Locale.ROOT,
            "<text x=\"%d\" y=\"%d\">%s%s</text>",
            x + LEFT,
            y + 13,
            MarkupText.of(SampledQuantity.name(quantity, component)),
            unit.isEmpty() ? "" : ", " + MarkupText.of(unit)));
    frame.axes(this);
    line(frame, ours, PENDANT_COLOUR);
    if (real.size() <= MAX_DOTS) {
      dots(frame, real);
    } else {
      line(frame, real, RECORDED_COLOUR);
    }
  }

  /** Where a panel is, and what it shows. */
  private record Frame(int left, int top, double fromS, double toS, double least, double most) {
    double x(double timeS) {
      double part = (timeS - fromS) / (toS - fromS);
      return left + LEFT + part * (PANEL_WIDTH - LEFT - RIGHT);
    }

    double y(double value) {
      double part = (value - least) / (most - least);
      return top + PANEL_HEIGHT - BOTTOM - part * (PANEL_HEIGHT - TOP - BOTTOM);
    }

    void axes(ChartSvg chart) {
      chart.add(
          String.format(
              Locale.ROOT,
              "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"none\""
                  + " stroke=\"#999999\"/>",
              x(fromS),
              y(most),
              x(toS) - x(fromS),
              y(least) - y(most)));
      for (double value : new double[] {least, (least + most) / 2, most}) {
        chart.add(
            String.format(
                Locale.ROOT,
                "<text x=\"%d\" y=\"%.1f\" text-anchor=\"end\" fill=\"#555555\">%s</text>",
                left + LEFT - 4,
                y(value) + 4,
                Difference.text(value)));
      }
      for (double timeS : new double[] {fromS, (fromS + toS) / 2, toS}) {
        chart.add(
            String.format(
                Locale.ROOT,
                "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\" fill=\"#555555\">%s</text>",
                x(timeS),
                top + PANEL_HEIGHT - 8,
                String.format(Locale.ROOT, "%.2f", timeS)));
      }
    }
  }

  /**
   * The samples of some rows, fewer where there are many; of each stretch both ends of its range.
   */
  private List<Point> points(Samples samples, int component, double shiftS, int from, int to) {
    int step = Math.max(1, 2 * (to - from + 1) / MAX_POINTS);
    List<Point> points = new ArrayList<>();
    for (int row = from; row <= to; row += step) {
      int lowest = row;
      int highest = row;
      for (int i = row; i < Math.min(to + 1, row + step); i++) {
        lowest = value(samples, component, i) < value(samples, component, lowest) ? i : lowest;
        highest = value(samples, component, i) > value(samples, component, highest) ? i : highest;
      }
      points.add(point(samples, component, shiftS, Math.min(lowest, highest)));
      if (lowest != highest) {
        points.add(point(samples, component, shiftS, Math.max(lowest, highest)));
      }
    }
    return points;
  }

  private double value(Samples samples, int component, int row) {
    return samples.value(quantity, component, row);
  }

  private Point point(Samples samples, int component, double shiftS, int row) {
    return new Point(samples.timeS(row) - shiftS, value(samples, component, row));
  }

  private void dots(Frame frame, List<Point> points) {
    svg.append("<path fill=\"none\" stroke-width=\"3.5\" stroke-linecap=\"round\" stroke=\"");
    svg.append(RECORDED_COLOUR).append("\" d=\"");
    for (Point point : points) {
      svg.append('M').append(place(frame, point)).append("h0");
    }
    svg.append("\"/>\n");
  }

  private void line(Frame frame, List<Point> points, String colour) {
    svg.append("<polyline fill=\"none\" stroke=\"").append(colour).append("\" points=\"");
    List<Point> corners = new ArrayList<>();
    corners.add(points.getFirst());
    addCorners(frame, points, 0, points.size() - 1, corners);
    svg.append(corners.stream().map(each -> place(frame, each)).collect(Collectors.joining(" ")));
    svg.append("\"/>\n");
  }

  /**
   * Adds what a line needs between two points, and the second of them: nothing that is closer to
   * the straight line than can be seen (D. Douglas and T. Peucker, 1973).
   */
  private static void addCorners(
      Frame frame, List<Point> points, int from, int to, List<Point> corners) {
    double x0 = frame.x(points.get(from).timeS());
    double y0 = frame.y(points.get(from).value());
    double dx = frame.x(points.get(to).timeS()) - x0;
    double dy = frame.y(points.get(to).value()) - y0;
    double length = Math.max(Math.hypot(dx, dy), 1e-9);
    int farthest = -1;
    double most = VISIBLE;
    for (int i = from + 1; i < to; i++) {
      double x = frame.x(points.get(i).timeS()) - x0;
      double y = frame.y(points.get(i).value()) - y0;
      double away = Math.abs(dx * y - dy * x) / length;
      if (away > most) {
        most = away;
        farthest = i;
      }
    }
    if (farthest < 0) {
      corners.add(points.get(to));
    } else {
      addCorners(frame, points, from, farthest, corners);
      addCorners(frame, points, farthest, to, corners);
    }
  }

  private static String place(Frame frame, Point point) {
    return String.format(Locale.ROOT, "%.1f,%.1f", frame.x(point.timeS()), frame.y(point.value()));
  }

  private void add(String line) {
    svg.append(line).append('\n');
  }
}
