package org.pendant.desktop.debug;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.ProgramTree.node;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.ControlHost;
import org.pendant.controller.installation.Installation;
import org.pendant.language.source.Source;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ControlScript;
import org.pendant.project.program.ExternalControl;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.WaitFor;
import org.pendant.project.program.script.GeneratedScript;
import org.pendant.project.program.script.ScriptGenerator;

/** A tree that was started at a node, while people see the script of all of it. */
final class PartialRunTest {
  private static final long FIRST = 2;
  private static final long SECOND = 3;
  private static final long WAIT = 4;

  private static final ProgramTree TREE =
      new ProgramTree("", Map.of(), List.of(), 1)
          .insert(
              ProgramTree.ROOT,
              0,
              List.of(
                  node(
                      new Section.MainProgram(true),
                      assign("first"),
                      assign("second"),
                      node(new ActionStep.Wait(new WaitFor.Time(0.1))))));

  private static final GeneratedScript WHOLE =
      ScriptGenerator.generate("test", TREE, Installation.NONE);
  private static final GeneratedScript PART =
      ScriptGenerator.generateFrom("test", TREE, SECOND, Installation.NONE);

  private final DebugFixture fixture =
      new DebugFixture(WHOLE.text().lines().toArray(String[]::new));
  private final DebugPresenter debug = fixture.debug();

  private static ProgramNode assign(String name) {
    return node(new ActionStep.Assignment(name, "1"));
  }

  private static int line(long key) {
    return WHOLE.of(key).orElseThrow().first();
  }

  private static RunScript part(int turnLine) {
    return new RunScript(
        Source.of("test", PART.text()),
        WHOLE.text(),
        RunLines.between(PART, WHOLE),
        turnLine,
        1,
        PART.names());
  }

  @Test
  void linesBelongToTheSameNode() {
    RunLines lines = RunLines.between(PART, WHOLE);
    List<Integer> first = lines.toRun(line(FIRST));
    List<Integer> second = lines.toRun(line(SECOND));
    assertEquals(1, first.size());
    assertEquals(2, second.size());
    assertTrue(second.getFirst() < first.getFirst());
    second.forEach(each -> assertEquals(line(SECOND), lines.toShown(each)));
    assertEquals(0, lines.toShown(0));
  }

  @Test
  void linesThatADriverHasSentBelongToTheirNodeAndKeepTheirNumbers() {
    ProgramTree tree =
        new ProgramTree("", Map.of(), List.of(), 1)
            .insert(
                ProgramTree.ROOT,
                0,
                List.of(
                    node(
                        new Section.MainProgram(false),
                        assign("first"),
                        node(
                            new ForeignStep.Contributed(
                                "FZI", ExternalControl.TYPE, List.of(), List.of())),
                        assign("last"))));
    ControlScript sent = ControlScript.of(ControlHost.STANDARD, "sync()\nhalt\n");
    GeneratedScript whole = ScriptGenerator.generate("test", tree, Installation.NONE);
    GeneratedScript run =
        ScriptGenerator.generate("test", tree, Installation.NONE, Optional.of(sent));
    RunLines lines = RunLines.between(run, whole, Optional.of(sent));
    int halt = 1 + run.text().lines().map(String::strip).toList().indexOf("halt");
    assertEquals(Optional.of("line 2 of the script from 192.168.56.1:50002"), lines.origin(halt));
    assertEquals(Optional.empty(), lines.origin(halt + 2));
    assertEquals(SECOND, whole.at(lines.toShown(halt)).orElseThrow().key());
    int last = whole.of(WAIT).orElseThrow().first();
    assertEquals(List.of(run.of(WAIT).orElseThrow().first()), lines.toRun(last));
  }

  @Test
  void aBreakpointHoldsInTheFirstTurnAndInTheOthers() {
    fixture.breakAt(line(SECOND));
    fixture.run(part(0));
    assertEquals(line(SECOND), fixture.execution().line());
    fixture.resume();
    fixture.advance();
    assertTrue(debug.held());
    assertEquals(line(SECOND), fixture.execution().line());
    assertEquals(
        2, debug.breakpoints().state(debug.breakpoints().all().getFirst()).orElseThrow().hits());
  }

  @Test
  void theMarkerIsAtTheNodeThatRuns() {
    fixture.breakAt(line(FIRST));
    fixture.run(part(0));
    assertEquals(line(FIRST), fixture.execution().line());
    debug.steps().over();
    fixture.advance();
    assertEquals(line(SECOND), fixture.execution().line());
  }

  @Test
  void runsToTheNextOfSeveralPlaces() {
    fixture.breakAt(line(FIRST));
    fixture.run(part(0));
    debug.steps().runTo(line(WAIT));
    fixture.advance();
    assertEquals(line(WAIT), fixture.execution().line());
  }

  @Test
  void turnsAreCountedWithoutStopping() {
    int first = PART.of(FIRST).orElseThrow().first();
    fixture.start(part(first - 1));
    fixture.frames(130);
    assertFalse(debug.held());
    debug.breakpoints().lookAtTurns();
    // One of its own, then one each 0.1 s.
    assertEquals(OptionalLong.of(3), debug.breakpoints().turns());
    assertEquals(List.of(), debug.breakpoints().all());
  }
}
