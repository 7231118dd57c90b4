package org.pendant.sweep.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.plan.PlanReader;
import org.pendant.sweep.plan.SweepPlan;
import org.pendant.sweep.plan.SweepVariant;
import org.pendant.sweep.plan.TargetText;
import org.pendant.sweep.search.SweepSearch;
import org.pendant.sweep.table.ResultTable;

/** The plans in examples/sweeps, a few variants of each. */
@Tag("slow")
final class SweepExamplesTest {
  private static SweepJob job(String name) throws PlanException {
    return SweepJob.read(Path.of("../../examples/sweeps", name));
  }

  @Test
  void baseInTheMiddleReachesShelfAndTableAndInACornerItDoesNot() throws PlanException {
    SweepJob job = job("place_base.toml");
    assertEquals(169, job.plan().size());
    assertEquals(RunOutcome.FINISHED, job.run(job.plan().variant(84)).outcome());
    assertTrue(!job.run(job.plan().variant(0)).outcome().ended());
  }

  @Test
  void fasterMovesTakeLessTime() throws PlanException {
    SweepJob job = job("tune_speeds.toml");
    SweepResult one = job.run(job.plan().variant(35));
    SweepResult other = job.run(job.plan().variant(82));
    assertEquals(RunOutcome.FINISHED, one.outcome());
    assertEquals("4", one.variables().getFirst());
    assertTrue(one.durationS() > other.durationS());
  }

  @Test
  void searchBeginsInTheMiddleOfItsRanges() throws PlanException {
    SweepJob job = job("search_speeds.toml");
    SweepSearch search = new SweepSearch(job.plan(), ResultTable.of(job.plan()));
    SweepVariant first = search.next().getFirst();
    assertEquals(0.875, first.values().getFirst().number());
    assertEquals(RunOutcome.FINISHED, job.run(first).outcome());
  }

  @Test
  void pegStandsElsewhereInEachRun() throws PlanException {
    SweepJob job = job("part_position.toml");
    SweepResult result = job.run(job.plan().variant(9));
    assertEquals(RunOutcome.FINISHED, result.outcome());
    assertTrue(result.forceN() > 5, result.forceN() + " N");
  }

  @Test
  void ofATreeItIsOfferedWhatItsScriptHas() throws PlanException {
    SweepPlan plan =
        PlanReader.read(
            "p.toml",
            "program = \"stack_boxes.pendant\"\n[[parameter]]\nset = \"seed\"\nvalues = [1]\n");
    List<String> offered =
        ParameterOffers.of(plan, Path.of("../../examples")).stream()
            .map(each -> TargetText.of(each.target()) + " " + each.now())
            .toList();
    assertTrue(offered.contains("variable Feeder_p[0] 0.45"), offered.toString());
    assertTrue(offered.contains("speed 1"), offered.toString());
  }
}
