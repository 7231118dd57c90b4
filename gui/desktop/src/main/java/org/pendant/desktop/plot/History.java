package org.pendant.desktop.plot;

import java.util.HashMap;
import java.util.Map;
import org.pendant.controller.state.ControllerState;

/**
 * Chart history: ten minutes of the quantities that are drawn: 125 samples a second, and of script
 * variables every frame. One thread uses it.
 */
final class History {
  private static final int KEPT_S = 600;

  private final PlotHistory plotHistory;
  private final TimeSeries samples;
  private final TimeSeries frames;

  /** One name for each script variable that is tracked, with its readings of the present frame. */
  private final Map<ChartQuantity, String> names = new HashMap<>();

  /** A history that follows a tape, beginning with what is on it. */
  History(PlotHistory plotHistory) {
    this.plotHistory = plotHistory;
    samples = new TimeSeries(KEPT_S * 125, plotHistory.first());
    frames = new TimeSeries(KEPT_S * 500, plotHistory.firstFrame());
  }

  /** Takes what is new on the tape; returns whether there was anything. */
  boolean follow() {
    boolean news = followSamples();
    return followFrames() || news;
  }

  private boolean followSamples() {
    long newest = plotHistory.end();
    if (newest == samples.end()) {
      return false;
    }
    if (plotHistory.first() > samples.end()) {
      // more has gone by than the tape holds: an honest gap is better than a line across it
      samples.startAt(plotHistory.first());
    }
    for (long number = samples.end(); number < newest; number++) {
      ControllerState state = plotHistory.at(number);
      samples.take(state.timeS(), quantity -> quantity.value().applyAsDouble(state));
    }
    return true;
  }

  private boolean followFrames() {
    long newest = plotHistory.endFrame();
    if (newest == frames.end()) {
      return false;
    }
    if (names.isEmpty()) {
      // they are not shown
      frames.startAt(newest);
      return false;
    }
    if (plotHistory.firstFrame() > frames.end()) {
      frames.startAt(plotHistory.firstFrame());
    }
    for (long number = frames.end(); number < newest; number++) {
      long frame = number;
      frames.take(
          plotHistory.timeS(frame),
          quantity -> plotHistory.traced(frame).value(names.get(quantity)));
    }
    return true;
  }

  /** The samples that a tracked quantity is in. */
  TimeSeries of(ChartQuantity quantity) {
    return quantity.variable() ? frames : samples;
  }

  /** Keeps a quantity from now on, and what the tape has of it. */
  void track(ChartQuantity quantity) {
    TimeSeries series = of(quantity);
    if (series.has(quantity)) {
      return;
    }
    if (quantity.variable()) {
      // the controller had not been asked for it
      names.put(quantity, quantity.id().substring(ScriptVariables.PREFIX.length()));
      frames.add(quantity);
      return;
    }
    samples.add(quantity);
    for (long number = Math.max(samples.first(), plotHistory.first());
        number < samples.end();
        number++) {
      samples.set(quantity, number, quantity.value().applyAsDouble(plotHistory.at(number)));
    }
  }

  /** Forgets a quantity. */
  void untrack(ChartQuantity quantity) {
    of(quantity).remove(quantity);
    names.remove(quantity);
  }

  boolean empty() {
    return samples.empty();
  }

  /** Time of the oldest sample, s; 0 without one. */
  double oldestS() {
    return empty() ? 0 : samples.timeS(samples.first());
  }

  /** Time of the newest sample, s; 0 without one. */
  double newestS() {
    return empty() ? 0 : samples.timeS(samples.end() - 1);
  }

  /** Value of a quantity at a time, that of the last sample until then; not a number before. */
  double valueAt(ChartQuantity quantity, double time) {
    return of(quantity).valueAt(quantity, time);
  }
}
