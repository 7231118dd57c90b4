package org.pendant.desktop.debug;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.TestController;
import org.pendant.desktop.editor.Execution;

final class DebugPresenterTest {
  private final DebugFixture fixture =
      new DebugFixture(
          "def program():",
          "  global total = 0",
          "  def add(amount):",
          "    local twice = 2 * amount",
          "    total = total + twice",
          "  end",
          "  add(1)",
          "  add(2)",
          "  sleep(1)",
          "end");
  private final DebugPresenter debug = fixture.debug();

  @Test
  void aBreakpointHoldsTheProgramAndShowsItsLine() {
    fixture.breakAt(5);
    fixture.run();
    assertTrue(debug.held());
    assertEquals(5, debug.executionLine());
    assertEquals("Breakpoint on line 5", debug.stopText());
    assertEquals(List.of("source 5:1"), fixture.told());
  }

  @Test
  void aProgramOfOthersIsNotHeldAtTheBreakpointsOfOurs() {
    fixture.breakAt(5);
    fixture.runStranger("def visitor():", "", "", "", "  sleep(0.1)", "end");
    assertFalse(debug.held());
  }

  @Test
  void aHeldProgramOfOthersShowsNoLineOfOurs() {
    debug.breakpoints().setOnErrors(true);
    fixture.runStranger("def visitor():", "  local n = 3", "  sleep(0 - n)", "end");
    assertTrue(debug.held());
    assertEquals(0, debug.executionLine());
    assertEquals(List.of(), fixture.told());
    assertEquals(3, debug.threads().getFirst().stack().getLast().line());
  }

  @Test
  void theSelectedCallSaysWhichVariablesAreShown() {
    fixture.breakAt(5);
    fixture.run();
    assertEquals(
        List.of("Local in add", "amount = 1", "twice = 2", "Global", "total = 0"),
        DebugFixture.rows(debug.variables()));
    debug.select(0, 1);
    assertEquals(7, debug.executionLine());
    assertEquals(List.of("Global", "total = 0"), DebugFixture.rows(debug.variables()));
  }

  @Test
  void theValuesOfAStopGoWhenAnotherControllerIsShown() {
    fixture.breakAt(5);
    fixture.run();
    Controller other = new Controller(ControllerOptions.headless());
    TestController.start(other, "sleep(1000)\n");
    other.runUntil(() -> false, 50);
    fixture.show("right", other.state());
    assertFalse(debug.held());
    assertFalse(debug.showsValues());
    assertEquals(List.of(), DebugFixture.rows(debug.variables()));
  }

  @Test
  void aSelectionThatDoesNotExistChangesNothing() {
    fixture.breakAt(5);
    fixture.run();
    Optional<Scope> before = debug.selected();
    debug.select(0, 9);
    debug.select(7, 1);
    assertEquals(before, debug.selected());
  }

  @Test
  void stepsGoOverIntoAndOut() {
    fixture.breakAt(7);
    fixture.run();
    debug.steps().over();
    fixture.advance();
    assertEquals(8, debug.executionLine());
    debug.steps().into();
    fixture.advance();
    assertEquals(4, debug.executionLine());
    debug.steps().out();
    fixture.advance();
    assertEquals(9, debug.executionLine());
    assertEquals("Stepped to line 9", debug.stopText());
  }

  @Test
  void itNamesTheNodeWhereAProgramOfNodesIsPaused() {
    debug.nameLinesBy(line -> "node " + 10 * line);
    fixture.breakAt(7);
    fixture.run();
    assertEquals("Breakpoint on node 70", debug.stopText());
    debug.steps().over();
    fixture.advance();
    assertEquals("Stepped to node 80", debug.stopText());
  }

  @Test
  void aRunToALineStopsThere() {
    fixture.breakAt(7);
    fixture.run();
    debug.steps().runTo(9);
    fixture.advance();
    assertEquals(9, debug.executionLine());
  }

  @Test
  void aRunningProgramIsHeldOnRequest() {
    fixture.breakAt(9);
    fixture.run();
    fixture.resume();
    fixture.frames(3);
    assertTrue(debug.steps().canPause());
    debug.steps().pause();
    fixture.frames(1);
    assertEquals("Paused at line 9", debug.stopText());
    assertFalse(debug.steps().canPause());
  }

  @Test
  void aStepFromAPauseEndsBeforeTheNextStatement() {
    DebugFixture waiting =
        new DebugFixture("def program():", "  sleep(1)", "  textmsg(1)", "  sleep(1)", "end");
    waiting.start();
    waiting.frames(3);
    waiting.pause();
    assertTrue(waiting.debug().steps().canStep());
    assertFalse(waiting.debug().steps().canKill());
    waiting.debug().steps().over();
    waiting.advance();
    assertEquals("Stepped to line 3", waiting.debug().stopText());
    assertEquals(3, waiting.debug().executionLine());
  }

  @Test
  void valuesLingerForAStepAndGoWhenTheProgramRunsOn() {
    fixture.breakAt(9);
    fixture.run();
    fixture.resume();
    fixture.frames(10);
    assertFalse(debug.held());
    assertTrue(debug.showsValues());
    fixture.frames(200);
    assertFalse(debug.showsValues());
    assertEquals(List.of(), DebugFixture.rows(debug.variables()));
    assertEquals(0, debug.executionLine());
  }

  @Test
  void refusalsAreTold() {
    debug.steps().over();
    assertEquals(List.of("Refused: the program is not paused"), fixture.told());
  }

  @Test
  void errorsHoldTheProgramWhenThatIsWanted() {
    DebugFixture failing = new DebugFixture("def program():", "  x = [1][2]", "end");
    failing.debug().breakpoints().setOnErrors(true);
    failing.run();
    assertTrue(failing.debug().held());
    assertFalse(failing.debug().steps().canStep());
    assertTrue(
        failing.debug().stopText().startsWith("Failed on line 2: "), failing.debug().stopText());
  }

  @Test
  void threadsAreListedWithTheirCallsAndCanBeEnded() {
    DebugFixture threads =
        new DebugFixture(
            "def program():",
            "  thread other():",
            "    sleep(5)",
            "  end",
            "  handle = run other()",
            "  sleep(0.1)",
            "  x = 1",
            "  y = 1",
            "end");
    threads.breakAt(7);
    threads.run();
    assertEquals(
        List.of(
            new CallRow(0, 0, "Main thread: program", "ready, line 7"),
            new CallRow(0, 1, "program", "line 7"),
            new CallRow(1, 0, "Thread 1: other", "waits in sleep, line 3"),
            new CallRow(1, 1, "other", "line 3")),
        CallRow.of(threads.debug().threads(), line -> "line " + line));
    threads.debug().nameLinesBy(line -> "node " + line);
    assertEquals(
        List.of(
            new CallRow(0, 0, "Main thread: program", "ready, node 7"),
            new CallRow(0, 1, "program", "node 7")),
        CallRow.of(threads.debug().threads(), threads.debug()::place).subList(0, 2));
    threads.debug().steps().kill(1);
    threads.frames(1);
    assertEquals(1, threads.debug().threads().size());
    assertEquals(7, threads.debug().executionLine());
  }

  @Test
  void aFailureIsShownAtItsLineUntilTheTextIsAnother() {
    DebugFixture failing = new DebugFixture("def program():", "  x = [1][2]", "end");
    failing.run();
    Execution ended = failing.execution();
    assertEquals(2, ended.line());
    assertEquals(Execution.State.FAILED, ended.state());
    assertTrue(ended.note().startsWith("index is 2"), ended.note());
    failing.edit("def program():\n  x = 1\nend\n");
    assertEquals(Execution.NONE, failing.execution());
  }

  @Test
  void theLineFollowsAnEditWhileTheProgramIsHeld() {
    fixture.breakAt(7);
    fixture.run();
    int line = fixture.debug().executionLine();
    fixture.edit("# a comment\n" + fixture.text());
    assertEquals(line + 1, fixture.debug().executionLine());
    assertEquals("Breakpoint on line " + (line + 1), fixture.debug().stopText());
    assertEquals(Execution.State.HELD, fixture.execution().state());
  }

  @Test
  void aStopOpensTheProgramThatWasClosed() {
    fixture.breakAt(7);
    fixture.close();
    fixture.run();
    assertTrue(fixture.isInFront());
  }
}
