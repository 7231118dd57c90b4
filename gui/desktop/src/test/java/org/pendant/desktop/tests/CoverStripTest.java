package org.pendant.desktop.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.editor.LineCover;
import org.pendant.desktop.editor.LineCover.Reach;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.testing.coverage.DecisionCoverage;
import org.pendant.testing.coverage.FileCoverage;
import org.pendant.testing.coverage.FunctionCoverage;
import org.pendant.testing.coverage.LineCoverage;
import org.pendant.testing.coverage.Share;

/** What tests have reached, beside the lines of a script that is edited. */
final class CoverStripTest {
  private static final List<String> TEXT =
      List.of("def grip(w):", "  if w > 3 and ready:", "    halt", "  end", "  sync()", "end");

  private static final FileCoverage FILE =
      new FileCoverage(
          "grip.script",
          TEXT,
          List.of(line(2, 1, 1, "a", "b"), line(3, 0, 1), line(5, 1, 2, "a")),
          List.of(new FunctionCoverage("grip", 1, List.of("a", "b"))),
          List.of(new DecisionCoverage(2, "w > 3 and ready", 2, 0)),
          List.of(new DecisionCoverage(2, "w > 3", 1, 1), new DecisionCoverage(2, "ready", 1, 0)));

  private final ProgramDocument program =
      ProgramDocument.untitled("grip.script", String.join("\n", TEXT) + "\n");
  private final Map<Integer, LineCover> shown = new TreeMap<>();
  private final Programs programs = new Programs(program);
  private boolean on = true;
  private Optional<CoverStrip.Reached> reached = Optional.of(new CoverStrip.Reached(FILE, 3));
  private int times;
  private final CoverStrip strip =
      new CoverStrip(
          programs,
          () -> on,
          _ -> reached,
          (document, lines) -> {
            shown.clear();
            shown.putAll(lines);
            times++;
          });

  private static LineCoverage line(int line, int reached, int total, String... tests) {
    return new LineCoverage(line, new Share(reached, total), List.of(tests));
  }

  @Test
  void eachLineSaysHowMuchOfItIsReachedAndWhatIsMissing() {
    strip.refresh();
    assertEquals(List.of(1, 2, 3, 5), List.copyOf(shown.keySet()));
    assertEquals(Reach.ALL, shown.get(1).reach());
    assertEquals("grip is called by 2 of 3 tests", shown.get(1).about());
    assertEquals(Reach.SOME, shown.get(2).reach());
    assertEquals(
        """
        Reached by 2 of 3 tests
        w > 3 and ready: never true
        ready: never true
        \u2022 a
        \u2022 b\
        """,
        shown.get(2).whole());
    assertEquals(Reach.NONE, shown.get(3).reach());
    assertEquals("No test reaches this line", shown.get(3).about());
    assertEquals(
        "Reached by 1 of 3 tests; 1 of 2 statements of the line are not reached",
        shown.get(5).about());
  }

  @Test
  void aLineThatIsEditedLosesItAndTheOthersMoveAndSayThatTheyAreOld() {
    strip.refresh();
    assertFalse(shown.get(3).stale());
    program.setText(program.text().replace("    halt\n", "    sleep(1)\n    popup(\"a\")\n"));
    strip.refresh();
    assertEquals(List.of(1, 2, 6), List.copyOf(shown.keySet()));
    assertTrue(shown.get(6).stale());
    assertTrue(shown.get(6).whole().endsWith("The text was edited since these tests ran."));
  }

  @Test
  void whatIsUndoneIsAsItWas() {
    String before = program.text();
    program.setText("x" + before);
    strip.refresh();
    program.setText(before);
    strip.refresh();
    assertFalse(shown.get(1).stale());
  }

  @Test
  void nothingIsShownAgainThatHasNotChanged() {
    strip.refresh();
    strip.refresh();
    assertEquals(1, times);
  }

  @Test
  void nothingStaysWhenItIsSwitchedOff() {
    strip.refresh();
    on = false;
    strip.refresh();
    assertEquals(Map.of(), shown);
    assertFalse(strip.shows(program));
    on = true;
    reached = Optional.empty();
    strip.refresh();
    assertEquals(2, times);
  }

  @Test
  void theNextLineThatIsMissingComesAfterThatOfTheCaretAndFromTheTopAgain() {
    strip.refresh();
    assertEquals(OptionalInt.of(2), strip.next(program, 1));
    assertEquals(OptionalInt.of(3), strip.next(program, 2));
    assertEquals(OptionalInt.of(2), strip.next(program, 5));
    reached =
        Optional.of(
            new CoverStrip.Reached(
                new FileCoverage(
                    "grip.script",
                    TEXT,
                    List.of(line(5, 1, 1, "a")),
                    List.of(),
                    List.of(),
                    List.of()),
                1));
    strip.refresh();
    assertEquals(OptionalInt.empty(), strip.next(program, 1));
  }
}
