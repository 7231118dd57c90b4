package org.pendant.script.debug;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramState;

/** Where programs stop. */
class BreakpointTest {
  private static final String LOOP =
      """
      def prog():
        i = 0
        while i < 3:
          # nothing here
          i = i + 1
          textmsg(i)
        end
        textmsg("end")
      end
      """;

  private final DebugFixture fixture = new DebugFixture();
  private final Debugger debugger = fixture.debugger;

  @Test
  void aBreakpointInALoopStopsOnEveryTurnBeforeItsStatement() {
    debugger.set(Breakpoint.at(6));
    fixture.start(LOOP).go();
    assertEquals(new PauseReason.AtBreakpoint(6, 1), fixture.stop().reason());
    assertEquals(6, fixture.line());
    assertEquals("1", fixture.value("i"));
    assertEquals(List.of(), fixture.messages());
    fixture.resume();
    assertEquals("2", fixture.value("i"));
    fixture.resume();
    assertEquals(new PauseReason.AtBreakpoint(6, 3), fixture.stop().reason());
    fixture.resume();
    assertInstanceOf(Ending.Finished.class, fixture.ending());
    assertEquals(List.of("1", "2", "3", "end"), fixture.messages());
  }

  @Test
  void aBreakpointOnALineWithoutStatementMovesToTheNext() {
    fixture.start(LOOP);
    assertEquals(OptionalInt.of(5), debugger.set(Breakpoint.at(4)).statementLine());
    assertEquals(OptionalInt.of(2), debugger.set(Breakpoint.at(1)).statementLine());
    assertEquals(OptionalInt.empty(), debugger.set(Breakpoint.at(9)).statementLine());
    fixture.go();
    assertEquals(2, fixture.line());
    fixture.resume();
    assertEquals(5, fixture.line());
  }

  @Test
  void aBreakpointIsPlacedWhenAProgramStarts() {
    assertEquals(OptionalInt.empty(), debugger.set(Breakpoint.at(4)).statementLine());
    fixture.start(LOOP);
    assertEquals(OptionalInt.of(5), debugger.breakpoints().getFirst().statementLine());
  }

  @Test
  void aBreakpointOnTheHeadOfALoopStopsBeforeEachTest() {
    debugger.set(Breakpoint.at(3));
    fixture.start(LOOP).go();
    for (int i = 0; i <= 3; i++) {
      assertEquals(3, fixture.line());
      assertEquals(Integer.toString(i), fixture.value("i"));
      fixture.resume();
    }
    assertInstanceOf(Ending.Finished.class, fixture.ending());
  }

  @Test
  void aBreakpointOnTheHeadOfALoopThatNeverEndsMeansItsFirstStatement() {
    debugger.set(Breakpoint.at(2));
    fixture.start("def prog():\n  while True:\n    sync()\n  end\nend\n").go();
    assertEquals(3, fixture.line());
    assertEquals(OptionalInt.of(3), debugger.breakpoints().getFirst().statementLine());
  }

  @Test
  void eachBranchOfAChoiceCanBeStoppedAt() {
    debugger.set(Breakpoint.at(5));
    fixture
        .start(
            """
            def prog():
              a = 2
              if a == 1:
                textmsg("one")
              elif a == 2:
                textmsg("two")
              end
            end
            """)
        .go();
    assertEquals(5, fixture.line());
    fixture.over();
    assertEquals(6, fixture.line());
  }

  @Test
  void theFirstOfSeveralStatementsOfALineIsMeant() {
    debugger.set(Breakpoint.at(2));
    fixture.start("def prog():\n  a = 1 b = 2\n  textmsg(b)\nend\n").go();
    fixture.resume();
    assertInstanceOf(Ending.Finished.class, fixture.ending());
  }

  @Test
  void aDisabledBreakpointDoesNothingUntilItIsEnabled() {
    debugger.set(Breakpoint.at(8));
    debugger.set(Breakpoint.at(6).disabled());
    fixture.start(LOOP).go();
    assertEquals(8, fixture.line());
    assertEquals(0, debugger.breakpoints().getFirst().hits());
  }

  @Test
  void aRemovedBreakpointStopsNoMore() {
    debugger.set(Breakpoint.at(6));
    fixture.start(LOOP).go();
    assertTrue(debugger.remove(6));
    assertFalse(debugger.remove(6));
    fixture.resume();
    assertInstanceOf(Ending.Finished.class, fixture.ending());
  }

  @Test
  void oneWithAMessageWritesItAndStopsNothing() {
    debugger.set(Breakpoint.at(6).logging("turn {i} of {i + missing}, {\"}\"}, {}"));
    fixture.start(LOOP).go();
    assertInstanceOf(Ending.Finished.class, fixture.ending());
    assertEquals(3, fixture.logged.size());
    assertTrue(fixture.logged.getFirst().startsWith("turn 1 of {i + missing: "));
    assertTrue(fixture.logged.getFirst().endsWith("}, }, {}"), fixture.logged.getFirst());
    assertEquals(3, debugger.breakpoints().getFirst().hits());
  }

  @Test
  void aMessageHasAConditionAndAFirstHitAsWell() {
    debugger.set(Breakpoint.at(6).when("i > 1").fromHit(2).logging("{i}"));
    fixture.start(LOOP).go();
    assertEquals(List.of("3"), fixture.logged);
  }

  @Test
  void onlyHitsWithATrueConditionStopAndCount() {
    debugger.set(Breakpoint.at(6).when("i == 2 or i > 2"));
    fixture.start(LOOP).go();
    assertEquals("2", fixture.value("i"));
    fixture.resume();
    assertEquals(new PauseReason.AtBreakpoint(6, 2), fixture.stop().reason());
    fixture.resume();
    assertEquals(2, debugger.breakpoints().getFirst().hits());
  }

  @Test
  void aConditionThatFailsStopsWithItsMessage() {
    debugger.set(Breakpoint.at(6).when("i + \"a\""));
    fixture.start(LOOP).go();
    PauseReason.ConditionFailed failed =
        assertInstanceOf(PauseReason.ConditionFailed.class, fixture.stop().reason());
    assertEquals(6, failed.line());
    assertTrue(failed.message().contains("string"), failed.message());
  }

  @Test
  void aConditionThatIsNoBoolStopsWithAMessage() {
    debugger.set(Breakpoint.at(6).when("[1]"));
    fixture.start(LOOP).go();
    assertInstanceOf(PauseReason.ConditionFailed.class, fixture.stop().reason());
  }

  @Test
  void aConditionMayNotTakeRobotTime() {
    debugger.set(Breakpoint.at(6).when("waiting()"));
    fixture
        .start(
            """
            def prog():
              def waiting():
                sleep(1)
                return True
              end
              textmsg("x")
            end
            """)
        .go();
    assertEquals(
        new PauseReason.ConditionFailed(
            6,
            "sleep takes robot time, an expression must be over at once and leave threads alone"),
        fixture.stop().reason());
  }

  @Test
  void aConditionLeavesNoTraceInVariables() {
    debugger.set(Breakpoint.at(7).when("counted() > 0 and l.append(1) == None"));
    fixture
        .start(
            """
            def prog():
              n = 0
              l = make_list(0, 0, 10)
              def counted():
                n = n + 1
                return n end
              textmsg(n, length(l))
            end
            """)
        .go();
    fixture.finish();
    assertEquals(List.of("00"), fixture.messages());
  }

  @Test
  void hitsBeforeTheFirstWantedPass() {
    debugger.set(Breakpoint.at(6).fromHit(3));
    fixture.start(LOOP).go();
    assertEquals(new PauseReason.AtBreakpoint(6, 3), fixture.stop().reason());
    assertEquals("3", fixture.value("i"));
  }

  @Test
  void aRuleSaysWhichHitsStop() {
    debugger.set(Breakpoint.at(6).counting(HitRule.of("% 2").orElseThrow()));
    fixture.start(LOOP).go();
    assertEquals(new PauseReason.AtBreakpoint(6, 2), fixture.stop().reason());
  }

  @Test
  void hitsAreCountedAnewInEveryRun() {
    debugger.set(Breakpoint.at(6).fromHit(3));
    fixture.start(LOOP).go().resume();
    fixture.start(LOOP).go();
    assertEquals(new PauseReason.AtBreakpoint(6, 3), fixture.stop().reason());
  }

  @Test
  void aBreakpointInARecursionStopsAtEveryDepth() {
    debugger.set(Breakpoint.at(4));
    fixture
        .start(
            """
            def prog():
              def down(n):
                if n == 0:
                  return 0
                end
                return down(n - 1)
              end
              textmsg(down(2))
            end
            """)
        .go();
    assertEquals(List.of("down:4", "down:6", "down:6", "prog:8"), fixture.stack());
    fixture.finish();
    assertEquals(List.of("0"), fixture.messages());
  }

  @Test
  void aBreakpointInAThreadNamesTheThread() {
    debugger.set(Breakpoint.at(3));
    fixture
        .start(
            """
            def prog():
              thread worker():
                textmsg("working")
              end
              h = run worker()
              join h
            end
            """)
        .go();
    assertEquals(1, fixture.stop().thread());
    assertEquals("worker", fixture.thread(1).name());
    assertEquals("thread 1", fixture.thread(0).waitsFor());
    assertEquals(6, fixture.thread(0).line());
  }

  @Test
  void aBreakpointSetWhileALoopIsHotStopsIt() {
    fixture.start(
        """
        def prog():
          i = 0
          while i < 100000000:
            i = i + 1
          end
        end
        """);
    fixture.advance(20);
    debugger.set(Breakpoint.at(4));
    fixture.go();
    assertEquals(4, fixture.line());
    String before = fixture.value("i");
    fixture.resume();
    assertEquals(Integer.toString(Integer.parseInt(before) + 1), fixture.value("i"));
  }

  @Test
  void functionsCalledByInterpretedLinesStop() {
    debugger.set(Breakpoint.at(3));
    fixture
        .start(
            """
            def prog():
              def double(x):
                return x * 2
              end
              interpreter_mode()
            end
            """)
        .advance(2);
    fixture.machine.interpreter().submit("textmsg(double(21))");
    fixture.go();
    assertEquals(List.of("double:3", "interpreter:1", "prog:5"), fixture.stack());
    fixture.machine.interpreter().submit("end_interpreter()");
    fixture.resume();
    assertEquals(List.of("42"), fixture.messages());
  }

  @Test
  void breakpointsOfAnotherRunOfTheSameProgramAreItsOwn() {
    DebugFixture other = new DebugFixture();
    debugger.set(Breakpoint.at(6));
    var program = fixture.compile(LOOP);
    fixture.machine.start(program);
    other.machine.start(program);
    other.go();
    assertInstanceOf(Ending.Finished.class, other.ending());
    fixture.go();
    assertEquals(6, fixture.line());
  }

  @Test
  void theProgramCanBeStoppedWhileItIsHeld() {
    debugger.set(Breakpoint.at(6));
    fixture.start(LOOP).go();
    fixture.machine.stop();
    assertFalse(debugger.state().held());
    assertEquals(ProgramState.STOPPED, fixture.machine.state());
    assertTrue(fixture.advance());
    assertEquals(Optional.of("the program is not paused"), DebugFixture.refusal(debugger::resume));
  }

  @Test
  void impossibleBreakpointsAreRefused() {
    assertEquals(
        Optional.of("line is 0, must be at least 1"), DebugFixture.refusal(() -> Breakpoint.at(0)));
    assertEquals(
        Optional.of("hit is 0, must be at least 1"),
        DebugFixture.refusal(() -> Breakpoint.at(1).fromHit(0)));
  }
}
