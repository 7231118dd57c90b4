package org.pendant.desktop.tests;

import static org.pendant.desktop.tests.TestsTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.Stroke;
import java.awt.geom.Path2D;
import java.util.List;
import java.util.Locale;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import javax.swing.JPanel;
import org.pendant.kit.theme.Palette;
import org.pendant.recording.compare.TrackCurves;
import org.pendant.recording.compare.TrackCurves.Point;

/** Golden plot: what differs first between a test and its recording, a moment before and after. */
@SuppressWarnings("serial") // never written to a stream
final class GoldenPlot extends JPanel {
  private static final TrackCurves NOTHING = new TrackCurves("", "", 0, List.of(), List.of());
  private static final Stroke LINE = new BasicStroke(2);
  private static final Stroke DASHED =
      new BasicStroke(2, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {6, 4}, 0);
  private static final Stroke HAIR = new BasicStroke(1);
  private static final double MARGIN = 0.1;
  private static final int SWATCH = 22;
  private static final String NEW = "new";
  private static final String GOLDEN = "golden";

  private transient TrackCurves curves = NOTHING;

  GoldenPlot() {
    setName("tests-golden-plot");
    setOpaque(false);
  }

  void show(TrackCurves wanted) {
    curves = wanted;
    String name =
        String.format(Locale.ROOT, text("ofTheNewRunAndThe"), wanted.what(), wanted.atS());
    setToolTipText(name);
    getAccessibleContext().setAccessibleName(name);
    repaint();
  }

  @Override
  public Dimension getPreferredSize() {
    return new Dimension(UIScale.scale(220), UIScale.scale(130));
  }

  @Override
  protected void paintComponent(Graphics g) {
    Graphics2D pen = (Graphics2D) g.create();
    pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    pen.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    pen.setFont(getFont());
    FontMetrics metrics = pen.getFontMetrics();
    int row = metrics.getHeight();
    int gap = UIScale.scale(4);
    pen.setColor(Palette.quiet());
    String unit = curves.unit().isEmpty() ? "" : ", " + curves.unit();
    String title = curves.what() + unit;
    pen.drawString(title, gap, metrics.getAscent());
    int behind = gap + metrics.stringWidth(title) + 3 * gap;
    boolean fits = behind + legendWidth(metrics, gap) <= getWidth();
    paintLegend(pen, metrics, fits ? behind : gap, fits ? 0 : row);
    int top = (fits ? row : 2 * row) + gap;
    Rectangle area = new Rectangle(gap, top, getWidth() - 2 * gap, getHeight() - top - row - gap);
    if (area.width > 0 && area.height > 0 && !curves.now().isEmpty()) {
      paint(pen, area, metrics);
    }
    pen.dispose();
  }

  private static int legendWidth(FontMetrics metrics, int gap) {
    return 2 * UIScale.scale(SWATCH) + metrics.stringWidth(NEW + GOLDEN) + 6 * gap;
  }

  private static void paintLegend(Graphics2D pen, FontMetrics metrics, int left, int top) {
    int gap = UIScale.scale(4);
    int swatch = UIScale.scale(SWATCH);
    int middle = top + metrics.getHeight() / 2;
    int x = left;
    for (boolean now : new boolean[] {true, false}) {
      String text = now ? NEW : GOLDEN;
      pen.setColor(color(now));
      pen.setStroke(now ? LINE : DASHED);
      pen.drawLine(x, middle, x + swatch, middle);
      pen.setColor(Palette.quiet());
      pen.drawString(text, x + swatch + gap, top + metrics.getAscent());
      x += swatch + metrics.stringWidth(text) + 4 * gap;
    }
  }

  private static Color color(boolean now) {
    return Palette.series(now ? 0 : 1);
  }

  private DoubleStream values() {
    return Stream.concat(curves.now().stream(), curves.before().stream()).mapToDouble(Point::value);
  }

  private void paint(Graphics2D pen, Rectangle area, FontMetrics metrics) {
    double low = values().min().orElse(0);
    double high = values().max().orElse(1);
    double room = Math.max((high - low) * MARGIN, curves.unit().isEmpty() ? MARGIN : 1e-3);
    double from = curves.now().getFirst().timeS();
    double to =
        Stream.of(curves.now(), curves.before())
            .filter(each -> !each.isEmpty())
            .mapToDouble(each -> each.getLast().timeS())
            .max()
            .orElse(from);
    View view = new View(area, from, Math.max(to, from + 1e-3), low - room, high + room);
    pen.setStroke(HAIR);
    pen.setColor(Palette.line());
    pen.drawRect(area.x, area.y, area.width - 1, area.height - 1);
    pen.setColor(Palette.warning());
    int at = (int) Math.round(view.x(curves.atS()));
    pen.drawLine(at, area.y, at, area.y + area.height - 1);
    paint(pen, view, curves.before(), false);
    paint(pen, view, curves.now(), true);
    pen.setColor(Palette.quiet());
    int base = area.y + area.height + metrics.getAscent();
    pen.drawString(seconds(view.fromS()), area.x, base);
    String end = seconds(view.toS());
    pen.drawString(end, area.x + area.width - metrics.stringWidth(end), base);
    String middle = seconds(curves.atS());
    int width = metrics.stringWidth(middle);
    int left = metrics.stringWidth(seconds(view.fromS()) + " ");
    int right = area.width - metrics.stringWidth(" " + end) - width;
    if (left <= right) {
      pen.setColor(Palette.warning());
      pen.drawString(middle, area.x + Math.clamp(at - area.x - width / 2, left, right), base);
    }
    if (!curves.unit().isEmpty()) {
      paintValues(pen, area, metrics, low, high);
    }
  }

  private static void paintValues(
      Graphics2D pen, Rectangle area, FontMetrics metrics, double low, double high) {
    if (area.height > 3 * metrics.getHeight()) {
      pen.setColor(Palette.quiet());
      int x = area.x + UIScale.scale(4);
      pen.drawString(String.format(Locale.ROOT, "%.2f", high), x, area.y + metrics.getAscent());
      pen.drawString(
          String.format(Locale.ROOT, "%.2f", low), x, area.y + area.height - metrics.getDescent());
    }
  }

  private static String seconds(double timeS) {
    return String.format(Locale.ROOT, "%.2f s", timeS);
  }

  private static void paint(Graphics2D pen, View view, List<Point> points, boolean now) {
    Path2D path = new Path2D.Double();
    for (Point each : points) {
      if (path.getCurrentPoint() == null) {
        path.moveTo(view.x(each.timeS()), view.y(each.value()));
      } else {
        path.lineTo(view.x(each.timeS()), view.y(each.value()));
      }
    }
    pen.setColor(color(now));
    pen.setStroke(now ? LINE : DASHED);
    pen.draw(path);
  }

  /** What of the curves is where. */
  private record View(Rectangle area, double fromS, double toS, double low, double high) {
    double x(double timeS) {
      return area.x + (timeS - fromS) / (toS - fromS) * (area.width - 1);
    }

    double y(double value) {
      return area.y + (high - value) / (high - low) * (area.height - 1);
    }
  }
}
