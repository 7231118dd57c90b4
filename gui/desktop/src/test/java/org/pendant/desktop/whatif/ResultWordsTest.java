package org.pendant.desktop.whatif;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.whatif.ResultWords.Figure;
import org.pendant.recording.whatif.JointTrack;
import org.pendant.recording.whatif.Peak;
import org.pendant.recording.whatif.TcpWay;
import org.pendant.recording.whatif.Variant;
import org.pendant.recording.whatif.VariantOutcome;

final class ResultWordsTest {
  private static VariantOutcome outcome(
      VariantOutcome.End end, double cycleS, double torque, double energyJ) {
    return new VariantOutcome(
        Variant.asItWas("some"),
        end,
        end == VariantOutcome.End.FINISHED ? "finished" : "wrong",
        cycleS,
        OptionalDouble.of(cycleS),
        0,
        Optional.of(new Peak(torque, "elbow", 4, 1.5)),
        Optional.of(new Peak(0.25, "base", 3, 0.5)),
        energyJ,
        TcpWay.NONE,
        JointTrack.NONE);
  }

  private static final VariantOutcome FIRST = outcome(VariantOutcome.End.FINISHED, 4, 0.4, 200);
  private static final VariantOutcome OTHER = outcome(VariantOutcome.End.FINISHED, 3, 0.65, 200);

  @Test
  void theFirstVariantStandsAlone() {
    assertEquals("4.000 s", ResultWords.figure(Figure.CYCLE, FIRST, Optional.empty()));
    assertEquals("40.0 %", ResultWords.figure(Figure.TORQUE, FIRST, Optional.empty()));
    assertEquals("200 J", ResultWords.figure(Figure.ENERGY, FIRST, Optional.empty()));
  }

  @Test
  void othersSayTheDifferenceToIt() {
    assertEquals(
        "3.000 s (\u221225 %)", ResultWords.figure(Figure.CYCLE, OTHER, Optional.of(FIRST)));
    assertEquals("65.0 % (+25)", ResultWords.figure(Figure.TORQUE, OTHER, Optional.of(FIRST)));
    assertEquals("200 J (=)", ResultWords.figure(Figure.ENERGY, OTHER, Optional.of(FIRST)));
  }

  @Test
  void theLeastIsTheBestUnlessAllAreTheSame() {
    List<VariantResult> results =
        List.of(new VariantResult.Done(FIRST), new VariantResult.Done(OTHER));
    assertFalse(ResultWords.best(Figure.CYCLE, 0, results));
    assertTrue(ResultWords.best(Figure.CYCLE, 1, results));
    assertTrue(ResultWords.best(Figure.TORQUE, 0, results));
    assertFalse(ResultWords.best(Figure.ENERGY, 0, results));
  }

  @Test
  void aVariantThatWasStoppedIsNeverTheBest() {
    List<VariantResult> results =
        List.of(
            new VariantResult.Done(FIRST),
            new VariantResult.Done(outcome(VariantOutcome.End.STOPPED, 1, 0.1, 10)),
            new VariantResult.Done(OTHER),
            new VariantResult.Refused("no"));
    assertFalse(ResultWords.best(Figure.CYCLE, 1, results));
    assertTrue(ResultWords.best(Figure.CYCLE, 2, results));
    assertFalse(ResultWords.best(Figure.CYCLE, 3, results));
    assertTrue(ResultWords.wrong(results.get(1)));
    assertTrue(ResultWords.wrong(results.get(3)));
    assertFalse(ResultWords.wrong(results.get(2)));
    assertEquals("Finished", ResultWords.state(results.get(0)));
  }

  @Test
  void aPeakIsExplained() {
    assertEquals(
        "Elbow, node 4, 1.500 s after the moment; in % of what the joint can do",
        ResultWords.about(Figure.TORQUE, FIRST, line -> "node " + line));
  }

  @Test
  void ofAProgramThatNeverEndsTheEnergyIsThatOfARound() {
    VariantOutcome loop =
        new VariantOutcome(
            Variant.asItWas("loop"),
            VariantOutcome.End.LIMIT,
            "still runs after 600.0 s",
            600,
            OptionalDouble.of(2),
            3,
            Optional.empty(),
            Optional.empty(),
            24_000,
            TcpWay.NONE,
            JointTrack.NONE);
    assertEquals("80 J/round", ResultWords.figure(Figure.ENERGY, loop, Optional.empty()));
    assertEquals("2.000 s/round", ResultWords.figure(Figure.CYCLE, loop, Optional.empty()));
    assertEquals("\u2013", ResultWords.figure(Figure.TORQUE, loop, Optional.empty()));
  }
}
