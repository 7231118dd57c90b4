package org.pendant.gui.plot;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** Quantities that are drawn on one pair of axes, in the order they were added. */
final class Chart {
  private final List<Trace> traces = new ArrayList<>();

  List<Trace> traces() {
    return List.copyOf(traces);
  }

  boolean empty() {
    return traces.isEmpty();
  }

  boolean has(Quantity quantity) {
    return traces.stream().anyMatch(each -> each.quantity().equals(quantity));
  }

  /** Adds a quantity in the first colour that is free, unless it is here. */
  void add(Quantity quantity) {
    if (!has(quantity)) {
      int color = 0;
      while (taken(color)) {
        color++;
      }
      traces.add(new Trace(quantity, color));
    }
  }

  private boolean taken(int color) {
    return traces.stream().anyMatch(each -> each.color() == color);
  }

  void remove(Quantity quantity) {
    traces.removeIf(each -> each.quantity().equals(quantity));
  }

  /** The unit of its axis; empty if its quantities differ in it. */
  String unit() {
    List<String> units = traces.stream().map(each -> each.quantity().unit()).distinct().toList();
    return units.size() == 1 ? units.getFirst() : "";
  }

  /** Whether a quantity of this unit belongs here rather than on a chart of its own. */
  boolean suits(Quantity quantity) {
    return !empty() && unit().equals(quantity.unit()) && traces.size() < 8;
  }

  /** Ids of the quantities, separated by commas. */
  String ids() {
    return traces.stream().map(each -> each.quantity().id()).collect(Collectors.joining(","));
  }
}
