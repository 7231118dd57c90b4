package org.pendant.desktop.waveform;

import static org.pendant.desktop.waveform.WaveformTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.Stroke;
import java.util.List;
import java.util.Locale;
import java.util.function.UnaryOperator;
import org.pendant.controller.io.InputChange;
import org.pendant.desktop.unit.TimeStep;
import org.pendant.kit.theme.Palette;
import org.pendant.models.time.FrameTime;

/** Waveform painter: draws the rows of inputs, and below them those of outputs. */
final class WaveformPainter {
  static final double FRAME_S = FrameTime.FRAME_S;

  /** How near the end of a recording or of the picture something may be, pixels. */
  private static final int MARGIN = 4;

  private final UnaryOperator<String> nameOf;

  /**
   * A painter.
   *
   * @param nameOf the name that people gave a signal; empty for none
   */
  WaveformPainter(UnaryOperator<String> nameOf) {
    this.nameOf = nameOf;
  }

  /** A signal with its name. */
  String title(String signal) {
    String name = nameOf.apply(signal);
    return name.isEmpty() ? signal : signal + "  " + name;
  }

  /** What a row is at a time, in words. */
  String about(WaveRow row, double timeS) {
    return String.format(
        Locale.ROOT,
        "%s at %.3f s: %s",
        title(row.signal()),
        timeS,
        row.at(timeS).orElse(text("asItIs")));
  }

  int rowHeight(Component canvas) {
    return (int) Math.round(1.6 * canvas.getFontMetrics(canvas.getFont()).getHeight());
  }

  void paint(Graphics2D pen, WaveformCanvas canvas) {
    Rectangle clip = pen.getClipBounds();
    pen.setColor(Palette.card());
    pen.fill(clip);
    grid(pen, canvas, clip);
    List<WaveRow> rows = canvas.sheet().rows();
    int height = rowHeight(canvas);
    for (int i = 0; i < rows.size(); i++) {
      int y = canvas.y(i);
      if (i == canvas.selected() && canvas.isFocusOwner()) {
        pen.setColor(Palette.tint(Palette.accent(), 0.12));
        pen.fillRect(clip.x, y, clip.width, height);
      }
      pen.setColor(Palette.line());
      pen.drawLine(clip.x, y + height - 1, clip.x + clip.width, y + height - 1);
      input(pen, canvas, rows.get(i), y, height);
    }
    for (int i = 0; i < canvas.capture().outputs().size(); i++) {
      int y = canvas.y(rows.size() + i);
      output(pen, canvas, canvas.capture().outputs().get(i), y, height);
    }
    lines(pen, canvas, clip);
  }

  private static void grid(Graphics2D pen, WaveformCanvas canvas, Rectangle clip) {
    double unit = gridS(canvas);
    pen.setColor(Palette.line());
    for (double i = Math.floor(canvas.timeAt(clip.x) / unit);
        canvas.x(i * unit) <= clip.x + clip.width;
        i++) {
      pen.drawLine(canvas.x(i * unit), clip.y, canvas.x(i * unit), clip.y + clip.height);
    }
  }

  /** How far times that are written stand apart, s. */
  static double gridS(WaveformCanvas canvas) {
    FontMetrics metrics = canvas.getFontMetrics(canvas.getFont());
    return TimeStep.atLeast(canvas.timeAt(metrics.stringWidth("0000.000 s   ")));
  }

  private static void input(Graphics2D pen, WaveformCanvas canvas, WaveRow row, int y, int height) {
    Color color = Palette.series(0);
    List<InputChange> changes = row.changes();
    int end = canvas.getWidth();
    int first = changes.isEmpty() ? end : canvas.x(changes.getFirst().timeS());
    dashed(pen, 0, first, y + height / 2);
    for (int i = 0; i < changes.size(); i++) {
      int from = canvas.x(changes.get(i).timeS());
      int to = i + 1 < changes.size() ? canvas.x(changes.get(i + 1).timeS()) : end;
      if (row.level()) {
        level(pen, color, WaveRow.high(changes.get(i).value()), i > 0, from, to, y, height);
      } else {
        number(pen, color, changes.get(i).value(), from, to, y, height);
      }
    }
  }

  private static void dashed(Graphics2D pen, int from, int to, int y) {
    Stroke before = pen.getStroke();
    pen.setColor(Palette.quiet());
    pen.setStroke(
        new BasicStroke(1, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 1, new float[] {3, 3}, 0));
    pen.drawLine(from, y, to, y);
    pen.setStroke(before);
  }

  private static void level(
      Graphics2D pen,
      Color color,
      boolean high,
      boolean edge,
      int from,
      int to,
      int y,
      int height) {
    int top = y + UIScale.scale(MARGIN);
    int bottom = y + height - UIScale.scale(MARGIN) - 1;
    if (high) {
      pen.setColor(Palette.tint(color, 0.3));
      pen.fillRect(from, top, to - from, bottom - top);
    }
    pen.setColor(color);
    pen.setStroke(new BasicStroke(UIScale.scale(1.5f)));
    pen.drawLine(from, high ? top : bottom, to, high ? top : bottom);
    if (edge) {
      pen.drawLine(from, top, from, bottom);
    }
  }

  private static void number(
      Graphics2D pen, Color color, String value, int from, int to, int y, int height) {
    int top = y + UIScale.scale(MARGIN);
    int inner = height - 2 * UIScale.scale(MARGIN);
    pen.setColor(Palette.tint(color, 0.15));
    pen.fillRect(from, top, to - from, inner);
    pen.setColor(color);
    pen.drawRect(from, top, to - from, inner);
    FontMetrics metrics = pen.getFontMetrics();
    if (metrics.stringWidth(value) + 2 * UIScale.scale(MARGIN) < to - from) {
      int base = y + (height + metrics.getAscent() - metrics.getDescent()) / 2;
      pen.drawString(value, from + UIScale.scale(MARGIN), base);
    }
  }

  private static void output(
      Graphics2D pen, WaveformCanvas canvas, WaveformCapture.OutputRow row, int y, int height) {
    Color color = Palette.series(1);
    boolean high = row.high();
    int from = 0;
    boolean edge = false;
    for (double edgeS : row.edgesS()) {
      int to = canvas.x(edgeS);
      level(pen, color, high, edge, from, to, y, height);
      from = to;
      high = !high;
      edge = true;
    }
    int end = Math.max(from, canvas.x(canvas.capture().lengthS()));
    level(pen, color, high, edge, from, end, y, height);
  }

  private static void lines(Graphics2D pen, WaveformCanvas canvas, Rectangle clip) {
    int bottom = clip.y + clip.height;
    canvas
        .sheet()
        .periodS()
        .ifPresent(
            periodS -> {
              int x = canvas.x(periodS);
              pen.setColor(Palette.tint(Palette.quiet(), 0.2));
              pen.fillRect(x, clip.y, Math.max(0, clip.x + clip.width - x), clip.height);
              pen.setColor(Palette.quiet());
              pen.drawLine(x, clip.y, x, bottom);
            });
    canvas
        .playS()
        .ifPresent(
            timeS -> {
              pen.setColor(Palette.ok());
              pen.setStroke(new BasicStroke(UIScale.scale(2f)));
              pen.drawLine(canvas.x(timeS), clip.y, canvas.x(timeS), bottom);
            });
    if (canvas.isFocusOwner()) {
      pen.setColor(Palette.accent());
      pen.setStroke(new BasicStroke(UIScale.scale(1.5f)));
      pen.drawLine(canvas.x(canvas.cursorS()), clip.y, canvas.x(canvas.cursorS()), bottom);
    }
  }
}
