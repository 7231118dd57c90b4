package org.pendant.desktop.sweep;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.LinkedHashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.pendant.sweep.run.RunOutcome;

class SweepWordsTest {
  @Test
  void aPlanTellsHowManyRunsItHas() {
    assertEquals("1 run", SweepWords.runs(1, false));
    assertEquals("1,200 runs", SweepWords.runs(1200, false));
  }

  @Test
  void aSearchTellsHowManyRunsItHasAtMost() {
    assertEquals("at most 1 run", SweepWords.runs(1, true));
    assertEquals("at most 400 runs", SweepWords.runs(400, true));
  }

  @Test
  void progressTellsTheRateOnceItIsKnownAndTheRestUntilItEnds() {
    assertEquals("0 of 1,000 runs", SweepWords.progress(0, 1000, 0, false));
    assertEquals(
        "400 of 1,000 runs, 300 a minute, 2 min 0 s left",
        SweepWords.progress(400, 1000, 5, false));
    assertEquals("1,000 of 1,000 runs, 300 a minute", SweepWords.progress(1000, 1000, 5, true));
  }

  @Test
  void outcomesAreCountedInTheWordsOfTables() {
    Map<String, Integer> counts = new LinkedHashMap<>();
    for (RunOutcome each : RunOutcome.values()) {
      assertEquals(each.word(), SweepWords.outcome(each.word()));
    }
    assertEquals("", SweepWords.outcomes(counts));
    counts.put("finished", 12);
    counts.put("never-ended", 1);
    assertEquals("12 finished, 1 never-ended", SweepWords.outcomes(counts));
  }

  @Test
  void durationsAreInTheTwoLargestUnits() {
    assertEquals("59 s", SweepWords.duration(59));
    assertEquals("2 min 5 s", SweepWords.duration(125));
    assertEquals("3 h 20 min", SweepWords.duration(12_000));
  }
}
