package org.pendant.sweep.search;

import java.util.ArrayList;
import java.util.List;
import org.pendant.sweep.plan.SearchGoal;
import org.pendant.sweep.table.ResultColumn;
import org.pendant.sweep.table.ResultTable;
import org.pendant.sweep.table.RowCondition;

/**
 * Search value: how good a run is. Of two that keep all limits the one with the better number is
 * better; one that keeps them is better than one that does not; of two that do not, the one that
 * misses them by less (Deb, An efficient constraint handling method, 2000).
 */
final class SearchValue {
  /** Worse than any number that keeps the limits. */
  private static final double MISSED = 1e12;

  /** A run without the number that is searched for. */
  private static final double NOTHING = 1e18;

  private final int column;
  private final boolean maximize;
  private final List<RowCondition> limits = new ArrayList<>();
  private final List<Integer> places = new ArrayList<>();

  /**
   * The values of a goal.
   *
   * @throws IllegalArgumentException for a column that is not there, or a limit that is none
   */
  SearchValue(SearchGoal goal, ResultTable table) {
    List<String> names = table.columns().stream().map(ResultColumn::name).toList();
    column = names.indexOf(goal.column());
    if (column < 0) {
      throw new IllegalArgumentException("there is no column " + goal.column() + " to search by");
    }
    maximize = goal.maximize();
    for (String each : goal.limits()) {
      RowCondition limit = RowCondition.parse(each, table.columns());
      limits.add(limit);
      places.add(names.indexOf(limit.column()));
    }
  }

  /** The value of a run by the cells of its row; the smaller the better. */
  double of(List<String> cells) {
    double missed = 0;
    for (int i = 0; i < limits.size(); i++) {
      missed += limits.get(i).missedBy(cells.get(places.get(i)));
    }
    if (missed > 0) {
      return MISSED * (1 + missed);
    }
    if (cells.get(column).isEmpty()) {
      return NOTHING;
    }
    double number = Double.parseDouble(cells.get(column));
    return maximize ? -number : number;
  }

  /** Whether a value is that of a run that keeps all limits. */
  static boolean keepsLimits(double value) {
    return value < MISSED;
  }
}
