package org.pendant.desktop.plot;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** Chart: quantities that are drawn on one pair of axes, in the order they were added. */
final class Chart {
  /** Lines beyond which a chart cannot be read. */
  static final int MOST = 12;

  /** Lines beyond which a chart takes no more by itself. */
  private static final int ENOUGH = 8;

  private final List<ChartTrace> traces = new ArrayList<>();

  List<ChartTrace> traces() {
    return List.copyOf(traces);
  }

  /** Whether it has as many lines as it can. */
  boolean full() {
    return traces.size() >= MOST;
  }

  boolean empty() {
    return traces.isEmpty();
  }

  boolean has(ChartQuantity quantity) {
    return traces.stream().anyMatch(each -> each.quantity().equals(quantity));
  }

  /** Adds a quantity in the first colour that is free, unless it is here. */
  void add(ChartQuantity quantity) {
    if (!has(quantity)) {
      int color = 0;
      while (taken(color)) {
        color++;
      }
      traces.add(new ChartTrace(quantity, color));
    }
  }

  private boolean taken(int color) {
    return traces.stream().anyMatch(each -> each.color() == color);
  }

  void remove(ChartQuantity quantity) {
    traces.removeIf(each -> each.quantity().equals(quantity));
  }

  /** The unit of its axis; empty if its quantities differ in it. */
  String unit() {
    List<String> units = traces.stream().map(each -> each.quantity().unit()).distinct().toList();
    return units.size() == 1 ? units.getFirst() : "";
  }

  /** Whether a quantity of this unit belongs here rather than on a chart of its own. */
  boolean suits(ChartQuantity quantity) {
    return !empty()
        && traces.size() < ENOUGH
        && traces.stream()
            .map(ChartTrace::quantity)
            .allMatch(
                each ->
                    each.unit().equals(quantity.unit()) && each.variable() == quantity.variable());
  }

  /** Ids of the quantities, separated by commas. */
  String ids() {
    return traces.stream().map(each -> each.quantity().id()).collect(Collectors.joining(","));
  }
}
