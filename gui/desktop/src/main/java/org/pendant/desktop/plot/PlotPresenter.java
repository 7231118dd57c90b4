package org.pendant.desktop.plot;

import static org.pendant.desktop.plot.PlotTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.pendant.kit.settings.Settings;

/**
 * Plot presenter: what the screen of charts shows: the charts, their stretch of time and the
 * cursors. Charts are remembered in the settings.
 */
final class PlotPresenter {
  private static final String CHARTS = "plot.charts";
  private static final String WIDTH = "plot.width-s";
  private static final String AT_FIRST =
      "actual_q_0,actual_q_1,actual_q_2,actual_q_3,actual_q_4,actual_q_5;tcp_speed";

  private final ChartQuantities quantities;
  private final History history;
  private final Settings settings;
  private final List<Chart> charts = new ArrayList<>();
  private TimeWindow window = TimeWindow.START;
  private Optional<Cursors> cursors = Optional.empty();
  private Consumer<List<String>> traced = paths -> {};
  private Consumer<String> told = text -> {};

  /** The charts that the settings remember; two examples if they remember none. */
  PlotPresenter(ChartQuantities quantities, History history, Settings settings) {
    this.quantities = quantities;
    this.history = history;
    this.settings = settings;
    settings.get(WIDTH).ifPresent(this::restoreWidth);
    for (String ids : settings.get(CHARTS).orElse(AT_FIRST).split(";", -1)) {
      restore(ids);
    }
  }

  private void restoreWidth(String text) {
    try {
      double seconds = Double.parseDouble(text);
      window = Double.isNaN(seconds) ? window : window.withWidth(seconds);
    } catch (NumberFormatException e) {
      // the user has edited the settings: the width stays what it is at first
      settings.put(WIDTH, Double.toString(window.widthS()));
    }
  }

  /** A chart of the quantities that are still known. */
  private void restore(String ids) {
    Chart chart = new Chart();
    for (String id : ids.split(",", -1)) {
      quantities.find(id).ifPresent(chart::add);
    }
    if (!chart.empty()) {
      charts.add(chart);
      chart.traces().forEach(each -> history.track(each.quantity()));
    }
  }

  /** Tells {@code listener} what cannot be done. */
  void onRefusal(Consumer<String> listener) {
    told = listener;
  }

  /** Tells {@code listener} which script variables are drawn, now and whenever that changes. */
  void onTraced(Consumer<List<String>> listener) {
    traced = listener;
    tellTraced();
  }

  private void tellTraced() {
    traced.accept(
        charts.stream()
            .flatMap(chart -> chart.traces().stream())
            .map(ChartTrace::quantity)
            .filter(ChartQuantity::variable)
            .map(quantity -> quantity.id().substring(ScriptVariables.PREFIX.length()))
            .distinct()
            .toList());
  }

  /** Takes new samples; returns whether anything in sight may have changed. */
  boolean refresh() {
    boolean news = history.follow();
    TimeWindow now = window.at(history.newestS());
    boolean moved = !now.equals(window);
    window = now;
    return news || moved;
  }

  List<Chart> charts() {
    return List.copyOf(charts);
  }

  /** Draws a quantity on the chart that suits its unit, or on a new one. */
  void add(ChartQuantity quantity) {
    if (charts.stream().noneMatch(each -> each.has(quantity))) {
      Optional<Chart> suitable = charts.stream().filter(each -> each.suits(quantity)).findFirst();
      if (suitable.isPresent()) {
        addTo(suitable.get(), quantity);
      } else {
        addChart(quantity);
      }
    }
  }

  /** Draws a quantity on a new chart. */
  void addChart(ChartQuantity quantity) {
    Chart chart = new Chart();
    charts.add(chart);
    addTo(chart, quantity);
  }

  /** Draws a quantity on a certain chart, unless that is full. */
  void addTo(Chart chart, ChartQuantity quantity) {
    if (chart.full() && !chart.has(quantity)) {
      told.accept(text("aChartHasAtMostLines", Chart.MOST));
      return;
    }
    history.track(quantity);
    chart.add(quantity);
    remember();
  }

  /** Takes a quantity off a chart; a chart without any goes. */
  void remove(Chart chart, ChartQuantity quantity) {
    chart.remove(quantity);
    if (chart.empty()) {
      charts.remove(chart);
    }
    forget(quantity);
    remember();
  }

  /** Takes a chart away. */
  void remove(Chart chart) {
    charts.remove(chart);
    chart.traces().forEach(each -> forget(each.quantity()));
    remember();
  }

  private void forget(ChartQuantity quantity) {
    if (charts.stream().noneMatch(each -> each.has(quantity))) {
      history.untrack(quantity);
    }
  }

  private void remember() {
    tellTraced();
    settings.put(CHARTS, charts.stream().map(Chart::ids).collect(Collectors.joining(";")));
  }

  ChartQuantities quantities() {
    return quantities;
  }

  History history() {
    return history;
  }

  TimeWindow window() {
    return window;
  }

  /** Shows another stretch of time. */
  void setWindow(TimeWindow wanted) {
    if (wanted.widthS() != window.widthS()) {
      settings.put(WIDTH, Double.toString(wanted.widthS()));
    }
    window = wanted.at(history.newestS());
  }

  boolean paused() {
    return !window.live();
  }

  /** Stands still, or continues with the newest sample; samples are kept meanwhile. */
  void pause(boolean wanted) {
    setWindow(window.withLive(!wanted));
  }

  Optional<Cursors> cursors() {
    return cursors;
  }

  /** Holds the charts still and shows the cursors in the middle of the lines, or hides them. */
  void showCursors(boolean wanted) {
    if (!wanted) {
      cursors = Optional.empty();
      return;
    }
    pause(true);
    double beginS = Math.min(Math.max(window.beginS(), history.oldestS()), window.endS());
    double thirdS = (window.endS() - beginS) / 3;
    cursors = Optional.of(new Cursors(beginS + thirdS, beginS + 2 * thirdS));
  }

  /** Moves the nearer cursor. */
  void moveCursor(double timeS) {
    cursors = cursors.map(present -> present.nearestTo(timeS));
  }

  /** Moves both or one cursor by a share of the window's width. */
  void shiftCursors(double shareA, double shareB) {
    double width = window.widthS();
    cursors =
        cursors.map(both -> new Cursors(both.aS() + shareA * width, both.bS() + shareB * width));
  }

  /** What the legend says about a quantity: its newest value, or those at the cursors. */
  String legend(ChartQuantity quantity) {
    double newest = history.valueAt(quantity, window.live() ? history.newestS() : window.endS());
    return cursors
        .map(
            both ->
                Readout.between(
                    quantity,
                    history.valueAt(quantity, both.aS()),
                    history.valueAt(quantity, both.bS())))
        .orElseGet(() -> Readout.of(quantity, newest));
  }
}
