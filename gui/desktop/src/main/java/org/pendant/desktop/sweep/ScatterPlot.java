package org.pendant.desktop.sweep;

import static org.pendant.desktop.sweep.SweepTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntConsumer;
import javax.swing.JPanel;
import org.pendant.desktop.plot.Scale;
import org.pendant.desktop.plot.TextPainting;
import org.pendant.kit.theme.Palette;
import org.pendant.sweep.run.RunOutcome;
import org.pendant.sweep.table.ResultColumn;

/** Scatter plot: two columns of all runs, coloured by their outcome or by a third column. */
@SuppressWarnings("serial") // never written to a stream
final class ScatterPlot extends JPanel {
  /** In place of a column: coloured by outcome. */
  static final int BY_OUTCOME = -1;

  private static final int NEAR = 10;
  private static final int MIN_DOT = 4;
  private static final int MAX_DOT = 9;

  private transient Optional<RunRows> rows = Optional.empty();
  private int x;
  private int y;
  private int color = BY_OUTCOME;
  private transient Optional<RunRow> marked = Optional.empty();

  /** Where the numbers of a column lie. */
  private record Span(double low, double high) {
    double share(double value) {
      return high > low ? (value - low) / (high - low) : 0.5;
    }
  }

  /**
   * Nothing yet.
   *
   * @param choose takes the place of the run that is clicked
   * @param open takes the place of the run that is clicked twice
   */
  ScatterPlot(IntConsumer choose, IntConsumer open) {
    setName("sweep-plot");
    setToolTipText("");
    getAccessibleContext().setAccessibleName(text("plotOfTwoColumnsOfAll"));
    addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent event) {
            int at = at(event.getX(), event.getY());
            if (at >= 0) {
              (event.getClickCount() == 2 ? open : choose).accept(at);
            }
          }
        });
  }

  /** Shows these columns. */
  void show(Optional<RunRows> wanted, int xColumn, int yColumn, int colorColumn) {
    rows = wanted;
    x = xColumn;
    y = yColumn;
    color = colorColumn;
    repaint();
  }

  /** Marks a run. */
  void mark(Optional<RunRow> run) {
    marked = run;
    repaint();
  }

  @Override
  public Dimension getPreferredSize() {
    return UIScale.scale(new Dimension(360, 260));
  }

  private Span span(int column) {
    RunRows of = rows.orElseThrow();
    double low = Double.POSITIVE_INFINITY;
    double high = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < of.size(); i++) {
      double value = of.get(i).number(column);
      if (!Double.isNaN(value)) {
        low = Math.min(low, value);
        high = Math.max(high, value);
      }
    }
    return new Span(low, high);
  }

  private Rectangle area(FontMetrics metrics) {
    int left = metrics.stringWidth("-0.0000") + UIScale.scale(10);
    int bottom = 2 * metrics.getHeight() + UIScale.scale(8);
    int top = metrics.getHeight() + UIScale.scale(10);
    return new Rectangle(
        left,
        top,
        Math.max(1, getWidth() - left - UIScale.scale(16)),
        Math.max(1, getHeight() - top - bottom));
  }

  /** Where dots may be: those at the ends are not cut off. */
  private static Rectangle inner(Rectangle area) {
    int by = UIScale.scale(MAX_DOT);
    return new Rectangle(
        area.x + by,
        area.y + by,
        Math.max(1, area.width - 2 * by),
        Math.max(1, area.height - 2 * by));
  }

  private Scale scale(int column, int most) {
    Span span = span(column);
    return span.low() > span.high()
        ? Scale.around(0, 1, most)
        : Scale.around(span.low(), span.high(), most);
  }

  private static int place(Scale scale, double value, int from, int length) {
    return from + (int) Math.round((value - scale.low()) / (scale.high() - scale.low()) * length);
  }

  private Scale across(Rectangle area, FontMetrics metrics) {
    return scale(x, Math.max(4, area.width / (2 * metrics.stringWidth("0000.00"))));
  }

  private Scale upwards(Rectangle area, FontMetrics metrics) {
    return scale(y, Math.max(2, area.height / (3 * metrics.getHeight())));
  }

  @Override
  protected void paintComponent(Graphics g) {
    super.paintComponent(g);
    Graphics2D pen = (Graphics2D) g.create();
    TextPainting.smooth(pen);
    FontMetrics metrics = pen.getFontMetrics();
    Rectangle area = area(metrics);
    pen.setColor(Palette.card());
    pen.fill(area);
    if (rows.isPresent() && rows.get().size() > 0 && x >= 0 && y >= 0) {
      Scale across = across(area, metrics);
      Scale upwards = upwards(area, metrics);
      axes(pen, area, across, upwards);
      pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
      dots(pen, inner(area), across, upwards);
    } else {
      pen.setColor(Palette.quiet());
      String text = text("noRunsYet");
      pen.drawString(
          text, area.x + (area.width - metrics.stringWidth(text)) / 2, area.y + area.height / 2);
    }
    pen.dispose();
  }

  private String name(int column) {
    ResultColumn of = rows.orElseThrow().columns().get(column);
    return of.unit().isEmpty() ? of.name() : of.name() + ", " + of.unit();
  }

  private void axes(Graphics2D pen, Rectangle area, Scale across, Scale upwards) {
    FontMetrics metrics = pen.getFontMetrics();
    Rectangle inner = inner(area);
    for (double tick : across.ticks()) {
      int at = place(across, tick, inner.x, inner.width);
      pen.setColor(Palette.line());
      pen.drawLine(at, area.y, at, area.y + area.height);
      pen.setColor(Palette.quiet());
      String text = across.text(tick);
      pen.drawString(
          text,
          Math.min(at - metrics.stringWidth(text) / 2, getWidth() - metrics.stringWidth(text)),
          area.y + area.height + metrics.getAscent() + 2);
    }
    for (double tick : upwards.ticks()) {
      int at = inner.y + inner.height - place(upwards, tick, 0, inner.height);
      pen.setColor(Palette.line());
      pen.drawLine(area.x, at, area.x + area.width, at);
      pen.setColor(Palette.quiet());
      String text = upwards.text(tick);
      pen.drawString(
          text,
          Math.max(0, area.x - metrics.stringWidth(text) - UIScale.scale(4)),
          at + metrics.getAscent() / 2);
    }
    pen.setColor(getForeground());
    pen.drawString(name(y), UIScale.scale(4), metrics.getAscent() + UIScale.scale(2));
    String below = name(x);
    pen.drawString(
        below,
        area.x + area.width - metrics.stringWidth(below),
        area.y + area.height + metrics.getHeight() + metrics.getAscent() + 2);
    if (color != BY_OUTCOME) {
      Span span = span(color);
      String words =
          name(color)
              + " "
              + SweepWords.brief(span.low())
              + " \u2026 "
              + SweepWords.brief(span.high());
      int width = UIScale.scale(60);
      int right = area.x + area.width;
      for (int i = 0; i < width; i++) {
        pen.setColor(shade(i / (double) width));
        pen.fillRect(right - width + i, UIScale.scale(4), 1, metrics.getAscent());
      }
      pen.setColor(Palette.quiet());
      pen.drawString(
          words,
          right - width - metrics.stringWidth(words) - UIScale.scale(6),
          metrics.getAscent() + UIScale.scale(2));
    }
  }

  /** From the accent to the warning: both differ in lightness from what lies behind. */
  private static Color shade(double share) {
    Color from = Palette.series(0);
    Color to = Palette.series(1);
    return new Color(
        mix(from.getRed(), to.getRed(), share),
        mix(from.getGreen(), to.getGreen(), share),
        mix(from.getBlue(), to.getBlue(), share));
  }

  private static int mix(int from, int to, double share) {
    return (int) Math.round(from + (to - from) * Math.clamp(share, 0, 1));
  }

  private Color color(RunRows of, RunRow row, Span span, Map<String, Color> outcomes) {
    if (color == BY_OUTCOME) {
      return outcomes.computeIfAbsent(
          of.outcome(row), word -> SweepWords.color(RunOutcome.of(word)));
    }
    double value = row.number(color);
    return Double.isNaN(value) ? Palette.quiet() : shade(span.share(value));
  }

  private void dots(Graphics2D pen, Rectangle area, Scale across, Scale upwards) {
    RunRows of = rows.orElseThrow();
    Span span = color == BY_OUTCOME ? new Span(0, 1) : span(color);
    // so that those of a grid do not touch
    double apart = Math.min(area.width, area.height) / Math.sqrt(Math.max(1, of.size()));
    int size =
        (int) Math.clamp(apart / 2, UIScale.scale((float) MIN_DOT), UIScale.scale((float) MAX_DOT));
    Map<String, Color> outcomes = new HashMap<>();
    // of many thousand dots most lie on others of their colour
    int[] painted = new int[(area.width + 1) * (area.height + 1)];
    for (int i = 0; i < of.size(); i++) {
      RunRow row = of.get(i);
      if (Double.isNaN(row.number(x)) || Double.isNaN(row.number(y))) {
        continue;
      }
      int right = place(across, row.number(x), 0, area.width);
      int up = place(upwards, row.number(y), 0, area.height);
      Color wanted = color(of, row, span, outcomes);
      int at = up * (area.width + 1) + right;
      if (painted[at] != wanted.getRGB()) {
        painted[at] = wanted.getRGB();
        pen.setColor(wanted);
        pen.fillOval(area.x + right - size / 2, area.y + area.height - up - size / 2, size, size);
      }
    }
    marked
        .filter(row -> !Double.isNaN(row.number(x)) && !Double.isNaN(row.number(y)))
        .ifPresent(
            row -> {
              pen.setColor(getForeground());
              pen.drawOval(
                  place(across, row.number(x), area.x, area.width) - size,
                  area.y + area.height - place(upwards, row.number(y), 0, area.height) - size,
                  2 * size,
                  2 * size);
            });
  }

  /** The place of the run that is nearest to a point; -1 where none is near. */
  private int at(int px, int py) {
    if (rows.isEmpty() || rows.get().size() == 0 || x < 0 || y < 0) {
      return -1;
    }
    FontMetrics metrics = getFontMetrics(getFont());
    Rectangle whole = area(metrics);
    Scale across = across(whole, metrics);
    Scale upwards = upwards(whole, metrics);
    Rectangle area = inner(whole);
    int best = -1;
    double nearest = Math.pow(UIScale.scale(NEAR), 2);
    for (int i = 0; i < rows.get().size(); i++) {
      RunRow row = rows.get().get(i);
      double dx = place(across, row.number(x), area.x, area.width) - px;
      double dy = area.y + area.height - place(upwards, row.number(y), 0, area.height) - py;
      if (!Double.isNaN(row.number(x))
          && !Double.isNaN(row.number(y))
          && dx * dx + dy * dy < nearest) {
        nearest = dx * dx + dy * dy;
        best = i;
      }
    }
    return best;
  }

  @Override
  public String getToolTipText(MouseEvent event) {
    int place = at(event.getX(), event.getY());
    if (place < 0) {
      return null;
    }
    RunRow row = rows.orElseThrow().get(place);
    return text(
        "runAtPoint",
        row.run(),
        SweepWords.outcome(rows.get().outcome(row)),
        name(x),
        SweepWords.brief(row.number(x)),
        name(y),
        SweepWords.brief(row.number(y)));
  }
}
