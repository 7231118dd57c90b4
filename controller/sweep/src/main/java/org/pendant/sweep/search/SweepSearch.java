package org.pendant.sweep.search;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.pendant.sweep.plan.ParameterValue;
import org.pendant.sweep.plan.SearchGoal;
import org.pendant.sweep.plan.SweepPlan;
import org.pendant.sweep.plan.SweepVariant;
import org.pendant.sweep.table.ResultTable;

/**
 * Search of a sweep: which variants come next, from the rows that there are. The same rows lead to
 * the same variants. Mutable, for one thread.
 */
public final class SweepSearch {
  private final SweepPlan plan;
  private final SearchGoal goal;
  private final SearchValue value;
  private final CmaEsSearch search;
  private final List<Double> values = new ArrayList<>();
  private long best = -1;
  private long bestGeneration;

  /**
   * The search of a plan that has a goal.
   *
   * @throws IllegalArgumentException if the goal names what the table has not
   */
  public SweepSearch(SweepPlan plan, ResultTable table) {
    this.plan = plan;
    goal = plan.search().orElseThrow();
    value = new SearchValue(goal, table);
    search = new CmaEsSearch(plan.parameters().size(), goal.population(), plan.sampling().seed());
  }

  /** Takes the next row of the table. */
  public void take(List<String> cells) {
    double found = value.of(cells);
    if (best < 0 || found < values.get((int) best)) {
      best = values.size();
      bestGeneration = generation(values.size());
    }
    values.add(found);
  }

  private long generation(int number) {
    return number == 0 ? 0 : 1 + (number - 1) / goal.population();
  }

  /**
   * The variants that come next: what is missing of a generation, or the next one; none when the
   * search has come to its end.
   */
  public List<SweepVariant> next() {
    int known = values.size();
    long generation = generation(known);
    int begun = generation == 0 ? 0 : (int) (1 + (generation - 1) * goal.population());
    if (known >= plan.size() || generation - bestGeneration > goal.stall()) {
      return List.of();
    }
    List<List<Double>> points = search.next(values.subList(0, begun));
    return IntStream.range(known - begun, points.size())
        .filter(i -> begun + i < plan.size())
        .mapToObj(i -> variant(begun + i, points.get(i)))
        .toList();
  }

  private SweepVariant variant(long number, List<Double> point) {
    List<ParameterValue> chosen =
        IntStream.range(0, point.size())
            .mapToObj(i -> plan.parameters().get(i).at(point.get(i)))
            .toList();
    return new SweepVariant(number, chosen);
  }

  /** The number of the best run so far; -1 before the first. */
  public long best() {
    return best;
  }

  /** Whether the best run keeps all limits. */
  public boolean bestKeepsLimits() {
    return best >= 0 && SearchValue.keepsLimits(values.get((int) best));
  }
}
