package org.pendant.sweep.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.plan.PlanReader;
import org.pendant.sweep.plan.SweepPlan;
import org.pendant.sweep.plan.SweepVariant;
import org.pendant.sweep.table.ResultTable;

final class SweepSearchTest {
  private static SweepPlan plan(String goal) throws PlanException {
    return PlanReader.read(
        "p.toml",
        "program = \"a.script\"\n[search]\n"
            + goal
            + """
            [[parameter]]
            name = "x"
            set = "speed"
            from = 1
            to = 3
            """);
  }

  /** The row of a run that takes as long as x is far from 2.4, and as much torque as x. */
  private static List<String> row(SweepPlan plan, SweepVariant variant) {
    List<String> names = ResultTable.of(plan).columns().stream().map(each -> each.name()).toList();
    List<String> cells = new ArrayList<>(Collections.nCopies(names.size(), ""));
    double x = variant.values().getFirst().number();
    cells.set(0, Long.toString(variant.number()));
    cells.set(1, Double.toString(x));
    cells.set(names.indexOf("outcome"), x < 1.1 ? "stopped" : "finished");
    if (x >= 1.1) {
      cells.set(names.indexOf("duration"), Double.toString(Math.abs(x - 2.4)));
      cells.set(names.indexOf("torque_share"), Double.toString(x / 3));
    }
    return cells;
  }

  private static List<SweepVariant> run(SweepPlan plan, SweepSearch search) {
    List<SweepVariant> all = new ArrayList<>();
    List<SweepVariant> next = search.next();
    while (!next.isEmpty()) {
      all.addAll(next);
      next.forEach(each -> search.take(row(plan, each)));
      next = search.next();
    }
    return all;
  }

  private static double best(SweepPlan plan) {
    SweepSearch search = new SweepSearch(plan, ResultTable.of(plan));
    List<SweepVariant> all = run(plan, search);
    for (int i = 0; i < all.size(); i++) {
      assertEquals(i, all.get(i).number());
    }
    assertTrue(search.bestKeepsLimits());
    return all.get((int) search.best()).values().getFirst().number();
  }

  @Test
  void leastOfAColumnIsFoundWithinTheLimits() throws PlanException {
    assertEquals(2.4, best(plan("minimize = \"duration\"\nruns = 150\n")), 0.01);
    assertEquals(
        2.1,
        best(plan("minimize = \"duration\"\nruns = 200\nlimits = [\"torque_share <= 0.7\"]\n")),
        0.01);
    assertEquals(
        3, best(plan("maximize = \"torque_share\"\nlimits = [\"outcome == finished\"]\n")), 0.01);
  }

  @Test
  void searchGoesOnFromItsRowsAloneAlsoInTheMiddleOfAGeneration() throws PlanException {
    SweepPlan plan = plan("minimize = \"duration\"\nruns = 60\nseed = 3\n");
    List<SweepVariant> whole = run(plan, new SweepSearch(plan, ResultTable.of(plan)));
    assertEquals(60, whole.size());
    SweepSearch resumed = new SweepSearch(plan, ResultTable.of(plan));
    whole.subList(0, 29).forEach(each -> resumed.take(row(plan, each)));
    assertEquals(whole.subList(29, 60), run(plan, resumed));
  }

  @Test
  void searchEndsWhenNothingGetsBetter() throws PlanException {
    SweepPlan plan = plan("maximize = \"line\"\nruns = 100000\nstall = 2\npopulation = 5\n");
    assertEquals(1 + 2 * 5, run(plan, new SweepSearch(plan, ResultTable.of(plan))).size());
  }

  @Test
  void variantOfARowIsTheOneThatRan() throws PlanException {
    SweepPlan plan = plan("minimize = \"duration\"\nruns = 30\n");
    for (SweepVariant each : run(plan, new SweepSearch(plan, ResultTable.of(plan)))) {
      assertEquals(each, plan.variantOfRow(each.number(), row(plan, each).subList(1, 2)));
    }
    assertThrows(IllegalStateException.class, () -> plan.variant(0));
  }

  @Test
  void goalThatIsNoneIsRefused() throws PlanException {
    SweepPlan plan = plan("minimize = \"duraton\"\n");
    assertThrows(IllegalArgumentException.class, () -> new SweepSearch(plan, ResultTable.of(plan)));
    assertThrows(PlanException.class, () -> plan("minimize = \"line\"\nmaximize = \"line\"\n"));
    assertThrows(PlanException.class, () -> plan("minimize = \"line\"\n[sampling]\nruns = 3\n"));
    assertFalse(plan("minimize = \"line\"\n").search().orElseThrow().maximize());
  }
}
