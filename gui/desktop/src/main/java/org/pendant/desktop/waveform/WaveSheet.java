package org.pendant.desktop.waveform;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.pendant.controller.io.InputChange;
import org.pendant.controller.io.InputWaveforms;

/**
 * Waveform sheet: all rows that are drawn.
 *
 * @param periodS after which everything happens again, s; empty if it happens once
 */
record WaveSheet(List<WaveRow> rows, OptionalDouble periodS) {
  /** Nothing is drawn yet. */
  static final WaveSheet EMPTY = new WaveSheet(List.of(), OptionalDouble.empty());

  WaveSheet {
    rows = List.copyOf(rows);
  }

  /** A row for each signal, in the order in which they come first. */
  static WaveSheet of(InputWaveforms waveforms) {
    Map<String, List<InputChange>> bySignal = new LinkedHashMap<>();
    for (InputChange each : waveforms.changes()) {
      bySignal.computeIfAbsent(each.signal(), signal -> new ArrayList<>()).add(each);
    }
    List<WaveRow> rows = new ArrayList<>();
    bySignal.forEach((signal, changes) -> rows.add(new WaveRow(signal, changes)));
    return new WaveSheet(rows, waveforms.periodS());
  }

  /**
   * What the controller plays; changes from the end of the period on are left out.
   *
   * @throws IllegalArgumentException if there is too much
   */
  InputWaveforms waveforms() {
    double endS = periodS.orElse(Double.POSITIVE_INFINITY);
    List<InputChange> all = new ArrayList<>();
    for (WaveRow row : rows) {
      row.changes().stream().filter(each -> each.timeS() < endS).forEach(all::add);
    }
    return new InputWaveforms(all, periodS);
  }

  /** The row of a signal; -1 if there is none. */
  int indexOf(String signal) {
    for (int i = 0; i < rows.size(); i++) {
      if (rows.get(i).signal().equals(signal)) {
        return i;
      }
    }
    return -1;
  }

  /** The same with one more row. */
  WaveSheet plus(WaveRow row) {
    List<WaveRow> all = new ArrayList<>(rows);
    all.add(row);
    return new WaveSheet(all, periodS);
  }

  /** The same with another row in place of one. */
  WaveSheet with(int index, WaveRow row) {
    List<WaveRow> all = new ArrayList<>(rows);
    all.set(index, row);
    return new WaveSheet(all, periodS);
  }

  /** The same without a row. */
  WaveSheet without(int index) {
    List<WaveRow> all = new ArrayList<>(rows);
    all.remove(index);
    return new WaveSheet(all, periodS);
  }

  /** The same with another period. */
  WaveSheet repeating(OptionalDouble period) {
    return new WaveSheet(rows, period);
  }

  /** When nothing changes any more, s. */
  double endS() {
    double last = rows.stream().mapToDouble(WaveRow::endS).max().orElse(0);
    return Math.max(last, periodS.orElse(0));
  }
}
