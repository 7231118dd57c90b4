package org.pendant.editors.dryrun;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.editors.dryrun.DryRunResult.Outcome;
import org.pendant.language.source.Source;

/** What a program does when nobody looks. */
final class DryRunTest {
  private static final DryRunLimits LONG =
      new DryRunLimits(Duration.ofMinutes(2), Duration.ofMinutes(2));

  private static DryRunResult run(String text, DryRunLimits limits) {
    return DryRun.of(Source.of("cell.script", text), "ur5e", limits, () -> false);
  }

  @Test
  void aProgramThatEndsTellsWhatItsLinesTook() {
    DryRunResult result =
        run("sleep(0.5)\nmovej([0, -1.2, 0, -1.57, 0, 0])\nset_digital_out(0, True)\n", LONG);
    assertEquals(Outcome.FINISHED, result.outcome());
    assertEquals(Optional.empty(), result.trouble());
    assertEquals(0.5, result.line(1).orElseThrow().timeS(), 0.01);
    assertTrue(result.line(2).orElseThrow().moved());
    assertEquals(result.timeS(), result.line(1).get().timeS() + result.line(2).get().timeS(), 0.02);
  }

  @Test
  void aPoseOutOfReachStopsTheArmInItsLine() {
    DryRunResult result = run("x = 1\nmovel(p[3, 0, 0.3, 0, 3.14, 0])\n", LONG);
    assertEquals(Outcome.STOPPED, result.outcome());
    assertEquals(2, result.trouble().orElseThrow().line());
  }

  @Test
  void aRunTimeErrorHasItsPlace() {
    DryRunResult result = run("x = [1, 2]\ny = x[5]\n", LONG);
    assertEquals(Outcome.FAILED, result.outcome());
    assertEquals(15, result.trouble().orElseThrow().range().orElseThrow().start());
  }

  @Test
  void aProgramThatWaitsForAnInputIsGivenUpInRobotTime() {
    DryRunResult result =
        run(
            "while not get_standard_digital_in(0):\n  sync()\nend\n",
            new DryRunLimits(Duration.ofSeconds(1), Duration.ofMinutes(2)));
    assertEquals(Outcome.GIVEN_UP, result.outcome());
    assertTrue(result.timeS() < 1.3, () -> "took " + result.timeS());
  }

  @Test
  void whoDoesNotWantToKnowAnyMoreEndsIt() {
    Source endless = Source.of("cell.script", "while True:\n  sleep(1)\nend\n");
    assertEquals(Outcome.GIVEN_UP, DryRun.of(endless, "ur5e", LONG, () -> true).outcome());
  }

  @Test
  void whatIsNoProgramIsNotRun() {
    assertEquals(Outcome.NOT_RUN, run("slep(1)\n", LONG).outcome());
    assertEquals(
        Outcome.NOT_RUN, run("sec now():\n  set_digital_out(0, True)\nend\n", LONG).outcome());
  }

  @Test
  void aProgramThatNeedsTheOutsideOrAPersonIsGivenUpWithoutAWord() {
    DryRunResult outside = run("ok = socket_open(\"127.0.0.1\", 9)\n", LONG);
    assertEquals(Outcome.GIVEN_UP, outside.outcome());
    assertEquals(Optional.empty(), outside.trouble());
    assertEquals(
        Outcome.GIVEN_UP, run("n = request_integer_from_primary_client(\"?\")\n", LONG).outcome());
  }
}
