package org.pendant.desktop.lines;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.debug.RunScript;
import org.pendant.desktop.editor.LineNote;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.settings.MemorySettings;
import org.pendant.kit.settings.Settings;
import org.pendant.recording.lines.LineStatistics;
import org.pendant.recording.lines.RunProfile;

/** What stands beside the lines of programs that are run and edited. */
final class PathStripTest {
  private static final String TEXT = "sleep(1)\nsleep(2)\nsleep(3)\n";

  private final Map<String, String> kept = new TreeMap<>();
  private final Settings settings = new MemorySettings(kept);
  private final ProgramDocument program = ProgramDocument.untitled("a.script", TEXT);
  private final Map<Integer, LineNote> shown = new TreeMap<>();
  private RunProfile profile = RunProfile.NONE;
  private long nowMs;
  private PathStrip strip;

  @BeforeEach
  void open() {
    strip = new PathStrip(settings, () -> profile, () -> nowMs);
    strip.showIn(
        (document, notes) -> {
          shown.clear();
          shown.putAll(notes);
        });
  }

  private static LineStatistics line(int line, long frames) {
    return new LineStatistics(line, 1, frames, frames, 0, 0, List.of());
  }

  private void run(LineStatistics... lines) {
    strip.beforeRun(program, RunScript.whole(program.source()));
    profile = new RunProfile(profile.run() + 1, "a", 0, List.of(lines));
    look();
  }

  private void look() {
    nowMs += 1000;
    strip.refresh();
  }

  @Test
  void whatALineTookBeginsWithWhatTheLineIsCalled() {
    run(line(2, 1000));
    String about = strip.about(program, 2, "node 15 Feeder").orElseThrow();
    assertTrue(about.startsWith("Node 15 Feeder in the last run:\n"), about);
    assertEquals(Optional.empty(), strip.about(program, 1, "line 1"));
  }

  @Test
  void linesHaveWhatTheyTookOfTheRun() {
    run(line(1, 500), line(2, 1000));
    assertEquals(List.of(1, 2), List.copyOf(shown.keySet()));
    assertEquals("67 % of the cycle: 2.00 s", shown.get(2).heat());
  }

  @Test
  void aLineThatIsEditedLosesItsNoteAndTheOthersMove() {
    run(line(1, 500), line(2, 1000), line(3, 1500));
    program.setText("sleep(1)\n\nsleep(9)\nsleep(3)\n");
    look();
    assertEquals(List.of(1, 4), List.copyOf(shown.keySet()));
    assertEquals("50 % of the cycle: 3.00 s", shown.get(4).heat());
  }

  @Test
  void theNextRunReplacesThem() {
    run(line(1, 500));
    run(line(3, 500));
    assertEquals(List.of(3), List.copyOf(shown.keySet()));
  }

  @Test
  void theyStayUntilTheNextRunHasBegun() {
    run(line(1, 500));
    strip.beforeRun(program, RunScript.whole(program.source()));
    look();
    assertEquals(List.of(1), List.copyOf(shown.keySet()));
  }

  @Test
  void aProgramOfOthersWhoseTextIsNotShownTakesThemAway() {
    run(line(1, 500));
    strip.strangerStarted(Optional.empty());
    profile = new RunProfile(profile.run() + 1, "b", 0, List.of(line(2, 100)));
    look();
    assertTrue(shown.isEmpty(), shown.toString());
  }

  @Test
  void aBranchFromTheRunBeforeShowsItsLinesInItsProgram() {
    run(line(1, 500), line(2, 500));
    RunProfile first = profile;
    ProgramDocument other = ProgramDocument.untitled("b.script", TEXT);
    strip.beforeRun(other, RunScript.whole(other.source()));
    profile = new RunProfile(2, "b", 700, List.of(line(3, 500)));
    look();
    assertEquals(Optional.empty(), strip.about(program, 1, "line 1"));

    profile = new RunProfile(1, first.name(), first.firstFrame(), List.of(line(1, 300)));
    look();
    assertEquals(List.of(1), List.copyOf(shown.keySet()));
    assertTrue(strip.about(program, 1, "line 1").isPresent());
    assertEquals(Optional.empty(), strip.about(other, 1, "line 1"));
  }

  @Test
  void aBranchToTheRunBeforeTellsWhichProgramRunsAgainAndItsTextThen() {
    List<Optional<PathStrip.Ran>> back = new ArrayList<>();
    strip.whenBack(back::add);
    run(line(1, 500));
    RunProfile first = profile;
    program.setText("sleep(9)\n" + TEXT);
    strip.beforeRun(ProgramDocument.untitled("b.script", TEXT), RunScript.whole(program.source()));
    profile = new RunProfile(2, "b", 700, List.of());
    look();
    assertEquals(List.of(), back);

    profile = first;
    look();
    assertEquals(program, back.getFirst().orElseThrow().document());
    assertEquals(TEXT, back.getFirst().orElseThrow().script().shown());
    assertEquals(1, back.size());
  }

  @Test
  void aBranchToARunOfOthersThatIsNotShownTellsOfNoProgram() {
    List<Optional<PathStrip.Ran>> back = new ArrayList<>();
    strip.whenBack(back::add);
    strip.strangerStarted(Optional.empty());
    profile = new RunProfile(1, "b", 0, List.of());
    look();
    RunProfile first = profile;
    run(line(1, 500));
    profile = first;
    look();
    assertEquals(List.of(Optional.empty()), back);
  }

  @Test
  void aStartThatCameToNothingIsNoneOfTheRunThatABranchGoesBackTo() {
    run(line(1, 500));
    RunProfile first = profile;
    run(line(2, 500));
    strip.beforeRun(ProgramDocument.untitled("c.script", TEXT), RunScript.whole(program.source()));
    profile = first;
    look();
    assertEquals(List.of(1), List.copyOf(shown.keySet()));
    assertTrue(strip.about(program, 1, "line 1").isPresent());
  }

  @Test
  void whoTurnsItOffSeesNothingAndOnAgainTheSame() {
    ActionTable actions = new ActionTable(settings);
    strip.addTo(actions);
    run(line(1, 500));
    actions.run("view.path-strip");
    assertTrue(shown.isEmpty(), shown.toString());
    assertEquals("false", kept.get("view.path-strip"));
    actions.run("view.path-strip");
    assertEquals(List.of(1), List.copyOf(shown.keySet()));
  }
}
