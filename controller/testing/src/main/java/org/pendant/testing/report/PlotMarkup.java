package org.pendant.testing.report;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.models.arm.Joints;
import org.pendant.testing.report.FailurePlot.Frame;

/** Plot markup: a {@link FailurePlot} as a picture in the page, without a file of its own. */
final class PlotMarkup {
  private static final int WIDTH = 860;
  private static final int LEFT = 92;
  private static final int RIGHT = 10;
  private static final int PANEL = 130;
  private static final int TITLE = 22;
  private static final int ROW = 18;
  private static final int STEP = 11;
  private static final int AXIS = 20;

  /** Most signals that are shown. */
  private static final int MAX_SIGNALS = 16;

  /** Points of a line at most, more than there are pixels tell nothing. */
  private static final int MAX_POINTS = 430;

  private final HtmlText html;
  private final FailurePlot plot;
  private final double fromS;
  private final double toS;

  PlotMarkup(HtmlText html, FailurePlot plot) {
    this.html = html;
    this.plot = plot;
    fromS = plot.frames().getFirst().timeS();
    toS = Math.max(plot.frames().getLast().timeS(), fromS + 0.01);
  }

  /** Writes it. */
  void write() throws IOException {
    List<Signal> all = signals();
    List<Signal> shown = all.subList(0, Math.min(MAX_SIGNALS, all.size()));
    int signalsTop = 2 * (TITLE + PANEL);
    int bottom = signalsTop + (shown.isEmpty() ? 0 : TITLE + shown.size() * ROW);
    String caption = "Joints and signals around the failure at " + seconds(plot.momentS());
    html.raw("<figure class=\"plot\"><svg role=\"img\" viewBox=\"0 0 " + WIDTH + " ");
    html.raw(bottom + AXIS + "\" aria-label=\"").text(caption).raw("\">\n");
    ticks(bottom);
    panel("Joint positions, °", 0, Frame::positionRad);
    panel("Joint speeds, °/s", TITLE + PANEL, Frame::speedRadPerS);
    if (!shown.isEmpty()) {
      String left =
          all.size() > shown.size() ? " (" + shown.size() + " of " + all.size() + ")" : "";
      text("title", LEFT, signalsTop + TITLE - 7, "start", "Signals" + left);
      for (int i = 0; i < shown.size(); i++) {
        signal(shown.get(i), signalsTop + TITLE + i * ROW);
      }
    }
    line("moment", x(plot.momentS()), 0, x(plot.momentS()), bottom);
    html.raw("</svg><figcaption>");
    for (int joint = 0; joint < Joints.COUNT; joint++) {
      html.element("span", "key j" + joint, "joint " + joint).raw(" ");
    }
    html.text(caption).raw("</figcaption></figure>\n");
  }

  /** Signals that are high at any time, or change. */
  private List<Signal> signals() {
    List<Signal> signals = new ArrayList<>();
    for (SignalBank bank : SignalBank.values()) {
      int high = 0;
      for (Frame each : plot.frames()) {
        high |= each.levels().bits(bank);
      }
      for (int i = 0; bank != SignalBank.FLAG && i < bank.size(); i++) {
        if ((high >> i & 1) != 0) {
          signals.add(new Signal(bank, i));
        }
      }
    }
    return signals;
  }

  private double x(double timeS) {
    return LEFT + (timeS - fromS) / (toS - fromS) * (WIDTH - LEFT - RIGHT);
  }

  private void ticks(int bottom) throws IOException {
    double step = step((toS - fromS) / 8);
    for (double at = Math.ceil(fromS / step) * step; at <= toS + step * 1e-6; at += step) {
      line("grid", x(at), 0, x(at), bottom);
      text("tick", x(at), bottom + AXIS - 6, "middle", number(at, step) + " s");
    }
  }

  /** 1, 2 or 5 times a power of ten, this or a little more. */
  private static double step(double least) {
    double power = Math.pow(10, Math.floor(Math.log10(least)));
    for (double each : new double[] {1, 2, 5}) {
      if (each * power >= least * (1 - 1e-9)) {
        return each * power;
      }
    }
    return 10 * power;
  }

  private void panel(String title, int top, Function<Frame, Joints> values) throws IOException {
    double low = Double.POSITIVE_INFINITY;
    double high = Double.NEGATIVE_INFINITY;
    for (Frame each : plot.frames()) {
      for (int joint = 0; joint < Joints.COUNT; joint++) {
        double value = Math.toDegrees(values.apply(each).get(joint));
        low = Math.min(low, value);
        high = Math.max(high, value);
      }
    }
    double step = step(Math.max(1e-3, (high - low) / 4));
    double bottomValue = Math.floor(low / step) * step;
    double topValue = Math.max(bottomValue + step, Math.ceil(high / step) * step);
    int first = top + TITLE;
    int height = PANEL - STEP;
    text("title", LEFT, first - 7, "start", title);
    for (double at = bottomValue; at <= topValue + step * 1e-6; at += step) {
      double y = first + (topValue - at) / (topValue - bottomValue) * height;
      line("grid", LEFT, y, WIDTH - RIGHT, y);
      text("tick", LEFT - 6, y + 4, "end", number(at, step));
    }
    for (int joint = 0; joint < Joints.COUNT; joint++) {
      int which = joint;
      html.raw("<polyline class=\"j" + joint + "\" points=\"");
      html.raw(
          points(
              each -> {
                double value = Math.toDegrees(values.apply(each).get(which));
                return first + (topValue - value) / (topValue - bottomValue) * height;
              }));
      html.raw("\"><title>joint " + joint + "</title></polyline>\n");
    }
  }

  /** The points of a line, those in the middle of a level part left out. */
  private String points(ToDoubleFunction<Frame> y) {
    List<Frame> frames = plot.frames();
    int every = Math.max(1, frames.size() / MAX_POINTS);
    StringBuilder points = new StringBuilder();
    String last = "";
    String left = "";
    for (int i = 0; i < frames.size(); i += every) {
      String height = pixels(y.applyAsDouble(frames.get(i)));
      String point = pixels(x(frames.get(i).timeS())) + "," + height + " ";
      if (height.equals(last)) {
        left = point;
      } else {
        points.append(left).append(point);
        left = "";
      }
      last = height;
    }
    return points.append(left).toString().strip();
  }

  private void signal(Signal signal, int top) throws IOException {
    text("tick", LEFT - 6, top + STEP, "end", signal.toString());
    StringBuilder path = new StringBuilder();
    boolean last = false;
    for (int i = 0; i < plot.frames().size(); i++) {
      Frame each = plot.frames().get(i);
      boolean level = each.levels().level(signal);
      String x = pixels(x(each.timeS()));
      if (i == 0) {
        path.append('M').append(x).append(' ').append(y(level, top));
      } else if (level != last) {
        path.append('H').append(x).append('V').append(y(level, top));
      }
      last = level;
    }
    path.append('H').append(WIDTH - RIGHT);
    html.raw("<path class=\"signal\" d=\"" + path + "\"/>\n");
  }

  private static int y(boolean level, int top) {
    return level ? top + 1 : top + STEP + 1;
  }

  private void line(String kind, double x1, double y1, double x2, double y2) throws IOException {
    html.raw("<line class=\"" + kind + "\" x1=\"" + pixels(x1) + "\" y1=\"" + pixels(y1));
    html.raw("\" x2=\"" + pixels(x2) + "\" y2=\"" + pixels(y2) + "\"/>\n");
  }

  private void text(String kind, double x, double y, String anchor, String text)
      throws IOException {
    html.raw("<text class=\"" + kind + "\" x=\"" + pixels(x) + "\" y=\"" + pixels(y));
    html.raw("\" text-anchor=\"" + anchor + "\">").text(text).raw("</text>\n");
  }

  private static String pixels(double value) {
    String text = String.format(Locale.ROOT, "%.1f", value);
    return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
  }

  private static String number(double value, double step) {
    int decimals = Math.clamp((long) Math.ceil(-Math.log10(step) - 1e-9), 0, 6);
    String text = String.format(Locale.ROOT, "%." + decimals + "f", value);
    return text.matches("-0(\\.0+)?") ? text.substring(1) : text;
  }

  private static String seconds(double timeS) {
    return String.format(Locale.ROOT, "%.3f s", timeS);
  }
}
