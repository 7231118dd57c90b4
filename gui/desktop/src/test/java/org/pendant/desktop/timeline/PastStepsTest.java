package org.pendant.desktop.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.Debugger;

final class PastStepsTest {
  private static final String SLEEPS =
      """
      i = 0
      sleep(0.1)
      i = 1
      sleep(0.1)
      i = 2
      sleep(0.1)
      """;

  private final RecordedRun run = new RecordedRun().start(SLEEPS);
  private final List<String> told = new ArrayList<>();

  /** Whether a debugger has paused the program of another controller. */
  private boolean otherHeld;

  private final List<Breakpoint> breakpoints = new ArrayList<>();
  private final LookBack lookBack = new LookBack(run.ring::recording, told::add);
  private final PastSteps steps =
      new PastSteps(
          lookBack,
          run::state,
          () -> otherHeld,
          ran -> breakpoints,
          new PastSteps.Threads(Runnable::run, Runnable::run),
          told::add);

  private void finish() {
    run.frames(200);
    lookBack.take(run.state());
  }

  @Test
  void stepsBackFromTheEndOfAProgramAndOnAgain() {
    finish();
    List<Integer> lines = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      steps.stepBack();
      lines.add(lookBack.line());
    }
    steps.stepOn();
    lines.add(lookBack.line());
    assertEquals(List.of(6, 4, 2, 4), lines);
    assertEquals(List.of(), told);
  }

  @Test
  void staysAtTheFirstStatementAndSaysSo() {
    finish();
    for (int i = 0; i < 4; i++) {
      steps.stepBack();
    }
    assertEquals(2, lookBack.line());
    assertEquals(List.of("The recording has no earlier statement"), told);
  }

  @Test
  void oneWhoseCellIsPausedByAnotherProgramNeedNotBe() {
    run.frames(10);
    otherHeld = true;
    assertEquals("", steps.whyNoBack());
  }

  @Test
  void aProgramThatRunsHasToBePausedFirst() {
    run.frames(10);
    assertTrue(steps.whyNoBack().startsWith("Pause the program first"));
    run.pause().frames(100);
    assertEquals("", steps.whyNoBack());
    assertFalse(steps.whyNoOn().isEmpty(), "there is something later than now");
    steps.stepBack();
    assertEquals("", steps.whyNoOn());
  }

  @Test
  void reverseContinueLeadsFromBreakpointToBreakpoint() {
    breakpoints.add(Breakpoint.at(2));
    breakpoints.add(Breakpoint.at(6).when("i == 7"));
    finish();
    steps.breakpointBefore();
    assertEquals(2, lookBack.line());
    steps.breakpointBefore();
    assertEquals(
        List.of(
            "The recording has no earlier breakpoint; those set later on what took no time are not"
                + " found"),
        told);
    breakpoints.add(Breakpoint.at(4).when("i == 1"));
    steps.breakpointAfter();
    assertEquals(4, lookBack.line());
  }

  @Test
  void withoutBreakpointsNoneIsSaidToBeMissed() {
    finish();
    steps.breakpointBefore();
    assertEquals(List.of("The recording has no earlier breakpoint"), told);
  }

  @Test
  void saysWhichConditionARecordingCannotTell() {
    breakpoints.add(Breakpoint.at(4).when("get_digital_in(1)"));
    finish();
    steps.breakpointBefore();
    assertFalse(lookBack.back());
    assertEquals(
        List.of(
            "The recording has no earlier breakpoint; it cannot tell whether the condition of"
                + " line 4 was true"),
        told);
  }

  @Test
  void goesToTheLastChangeOfTheSelectedVariable() {
    finish();
    assertTrue(steps.whyNoChange().startsWith("Select a variable"));
    steps.watch("i");
    assertEquals("", steps.whyNoChange());
    steps.changeBefore();
    steps.changeBefore();
    assertEquals(4, lookBack.line());
    assertEquals(List.of("i changed from 1 to 2", "i changed from 0 to 1"), told);
    steps.changeAfter();
    assertEquals(6, lookBack.line());
    steps.watch("i + 1");
    assertTrue(steps.whyNoChange().startsWith("i + 1 is no variable"));
  }

  @Test
  void nothingIsShownWherePeopleLookElsewhereMeanwhile() {
    finish();
    List<Runnable> later = new ArrayList<>();
    PastSteps slow =
        new PastSteps(
            lookBack,
            run::state,
            () -> otherHeld,
            ran -> breakpoints,
            new PastSteps.Threads(Runnable::run, later::add),
            told::add);
    slow.stepBack();
    lookBack.scrub(0.05);
    later.getFirst().run();
    assertEquals(0.05, lookBack.timeS().orElseThrow());
  }

  @Test
  void aBranchFromAStopBeginsBeforeItsFrame() {
    run.ask(debugger -> debugger.set(Breakpoint.at(4))).frames(80);
    assertTrue(run.state().debug().held());
    long stopped = run.state().frame();
    steps.stepBack();
    steps.stepOn();
    assertEquals(stopped, lookBack.branchStart().orElseThrow().frame(), "it is still held there");

    run.ask(Debugger::resume).frames(100);
    breakpoints.add(Breakpoint.at(4));
    lookBack.live();
    steps.breakpointBefore();
    assertEquals(stopped, lookBack.moment().orElseThrow().frame());
    assertEquals(stopped - 1, lookBack.branchStart().orElseThrow().frame());
  }
}
