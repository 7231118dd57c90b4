package org.pendant.desktop.sweep;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.pendant.sweep.table.CellType;
import org.pendant.sweep.table.ResultColumn;

/** Rows of runs: the table of a sweep as far as the window shows it. One thread uses it. */
final class RunRows {
  /** The window shows so many; the file has them all. */
  static final int MAX_ROWS = 100_000;

  private final List<ResultColumn> columns;
  private final List<RunRow> rows = new ArrayList<>();
  private final Map<String, Integer> outcomes = new TreeMap<>();
  private final int outcome;

  RunRows(List<ResultColumn> columns) {
    this.columns = List.copyOf(columns);
    outcome = column("outcome");
  }

  List<ResultColumn> columns() {
    return columns;
  }

  /** The place of a column; -1 for one that is not there. */
  int column(String name) {
    for (int i = 0; i < columns.size(); i++) {
      if (columns.get(i).name().equals(name)) {
        return i;
      }
    }
    return -1;
  }

  /** The places of the columns of numbers. */
  List<Integer> numbers() {
    List<Integer> found = new ArrayList<>();
    for (int i = 0; i < columns.size(); i++) {
      if (columns.get(i).type() != CellType.TEXT) {
        found.add(i);
      }
    }
    return found;
  }

  void add(List<RunRow> more) {
    for (RunRow each : more) {
      if (rows.size() < MAX_ROWS) {
        rows.add(each);
      }
      outcomes.merge(each.text(outcome), 1, Integer::sum);
    }
  }

  int size() {
    return rows.size();
  }

  RunRow get(int place) {
    return rows.get(place);
  }

  /** How a run ended. */
  String outcome(RunRow row) {
    return row.text(outcome);
  }

  /** How many runs ended in each way, also those that are not shown. */
  Map<String, Integer> outcomes() {
    return outcomes;
  }
}
