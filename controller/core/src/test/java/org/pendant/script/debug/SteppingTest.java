package org.pendant.script.debug;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ThreadSnapshot;

/** Steps of a thread, and other ways to be held. */
class SteppingTest {
  private static final String CALLS =
      """
      def prog():
        def twice(x):
          local y = x * 2
          return y
        end
        a = twice(1) + twice(2)
        b = a
        textmsg(b)
      end
      """;

  private final DebugFixture fixture = new DebugFixture();
  private final Debugger debugger = fixture.debugger;

  @Test
  void steppingOverACallStaysInTheFunction() {
    debugger.set(Breakpoint.at(6));
    fixture.start(CALLS).go().over();
    assertEquals(7, fixture.line());
    assertEquals(new PauseReason.Stepped(), fixture.stop().reason());
    assertEquals("6", fixture.value("a"));
  }

  @Test
  void theFirstStepOfAProgramHeldAtItsBeginIsOverItsFirstStatement() {
    fixture.start(CALLS);
    debugger.pause();
    assertEquals(6, fixture.line());
    fixture.over();
    assertEquals(7, fixture.line());
    assertEquals("6", fixture.value("a"));
  }

  @Test
  void steppingIntoACallStopsAtItsFirstStatement() {
    debugger.set(Breakpoint.at(6));
    fixture.start(CALLS).go().into();
    assertEquals(List.of("twice:3", "prog:6"), fixture.stack());
    assertEquals("1", fixture.value("x"));
    fixture.into();
    fixture.into();
    assertEquals(List.of("twice:3", "prog:6"), fixture.stack());
    assertEquals("2", fixture.value("x"));
  }

  @Test
  void steppingOverTheLastStatementOfAFunctionFinishesTheStatementThatCalledIt() {
    debugger.set(Breakpoint.at(4));
    fixture.start(CALLS).go();
    debugger.removeBreakpoints();
    fixture.over();
    assertEquals(7, fixture.line());
  }

  @Test
  void steppingOutFinishesTheStatementThatCalled() {
    debugger.set(Breakpoint.at(3));
    fixture.start(CALLS).go();
    debugger.removeBreakpoints();
    fixture.out();
    assertEquals(7, fixture.line());
    assertEquals("6", fixture.value("a"));
  }

  @Test
  void aStepToACallStopsInWhateverThreadComesToOne() {
    debugger.set(Breakpoint.at(8));
    fixture
        .start(
            """
            def prog():
              thread other():
                sleep(0.1)
                set_tool_voltage(12)
                sleep(1)
              end
              h = run other()
              sleep(0.2)
              sync()
              set_tool_voltage(24)
              sync()
            end
            """)
        .go();
    debugger.removeBreakpoints();
    toCall();
    assertEquals(List.of("other:4"), fixture.stack());
    toCall();
    assertEquals(List.of("other:5"), fixture.stack());
    toCall();
    assertEquals(List.of("prog:10"), fixture.stack());
    toCall();
    assertEquals(List.of("prog:11"), fixture.stack());
    toCall();
    assertInstanceOf(Ending.class, fixture.ending());
  }

  @Test
  void aStepToACallGoesOnWhenItsThreadHasEnded() {
    debugger.set(Breakpoint.at(3));
    fixture
        .start(
            """
            def prog():
              thread other():
                set_tool_voltage(12)
              end
              h = run other()
              sleep(0.1)
              set_tool_voltage(24)
            end
            """)
        .go();
    debugger.removeBreakpoints();
    toCall();
    assertEquals(List.of("prog:7"), fixture.stack());
  }

  private void toCall() {
    debugger.stepToCall(fixture.stop().thread(), Set.of("set_tool_voltage"));
    fixture.go();
  }

  @Test
  void aBreakpointInsideOfACallThatIsSteppedOverStops() {
    debugger.set(Breakpoint.at(6));
    debugger.set(Breakpoint.at(4));
    fixture.start(CALLS).go().over();
    assertEquals(new PauseReason.AtBreakpoint(4, 1), fixture.stop().reason());
    assertEquals("2", fixture.value("y"));
  }

  @Test
  void steppingOverARecursiveCallStaysAtItsDepth() {
    debugger.set(Breakpoint.at(6).when("n == 3"));
    fixture
        .start(
            """
            def prog():
              def sum(n):
                if n == 0:
                  return 0
                end
                local rest = sum(n - 1)
                return rest + n
              end
              textmsg(sum(5))
            end
            """)
        .go();
    assertEquals(4, fixture.stack().size());
    fixture.over();
    assertEquals("sum:7", fixture.stack().getFirst());
    assertEquals(4, fixture.stack().size());
    assertEquals("3", fixture.value("rest"));
    fixture.out();
    assertEquals(3, fixture.stack().size());
    assertEquals("6", fixture.value("rest"));
    fixture.finish();
    assertEquals(List.of("15"), fixture.messages());
  }

  @Test
  void steppingGoesRoundALoop() {
    debugger.set(Breakpoint.at(2));
    fixture
        .start(
            """
            def prog():
              i = 0
              while i < 2:
                i = i + 1
              end
              textmsg(i)
            end
            """)
        .go();
    StringBuilder lines = new StringBuilder();
    for (int i = 0; i < 6; i++) {
      lines.append(fixture.over().line()).append(' ');
    }
    assertEquals("3 4 3 4 3 6 ", lines.toString());
  }

  @Test
  void theProgramEndsWhenItsLastStatementIsSteppedOver() {
    debugger.set(Breakpoint.at(8));
    fixture.start(CALLS).go().over();
    assertInstanceOf(Ending.Finished.class, fixture.ending());
    assertFalse(debugger.state().held());
  }

  @Test
  void aStepOverAWaitIsOverWhenTheWaitIs() {
    debugger.set(Breakpoint.at(2));
    fixture.start("def prog():\n  sleep(0.1)\n  textmsg(1)\nend\n").go();
    int before = fixture.frames;
    fixture.over();
    assertEquals(3, fixture.line());
    assertEquals(50, fixture.frames - before);
  }

  @Test
  void aStepOverAMoveIsOverWhenTheArmHasArrived() {
    debugger.set(Breakpoint.at(2));
    fixture.start("def prog():\n  movej([0.1, -1.5, 1, -1, -1.5, 0])\n  textmsg(1)\nend\n").go();
    fixture.over();
    assertEquals(3, fixture.line());
    assertEquals(0.1, fixture.box.motion().positionRad().get(0), 1e-9);
  }

  @Test
  void steppingNeverEntersAnotherThread() {
    debugger.set(Breakpoint.at(9));
    fixture
        .start(
            """
            def prog():
              thread other():
                while True:
                  textmsg("other")
                  sync()
                end
              end
              run other()
              sleep(0.01)
              textmsg("main")
            end
            """)
        .go()
        .into();
    assertEquals(0, fixture.stop().thread());
    assertEquals(10, fixture.line());
    assertEquals(List.of("other", "other", "other", "other", "other"), fixture.messages());
  }

  @Test
  void anotherThreadThanTheStoppedOneCanStep() {
    debugger.set(Breakpoint.at(7));
    fixture
        .start(
            """
            def prog():
              thread other():
                textmsg("a")
                textmsg("b")
              end
              h = run other()
              textmsg("main")
              join h
            end
            """)
        .go();
    debugger.stepInto(1);
    fixture.go();
    assertEquals(1, fixture.stop().thread());
    assertEquals(3, fixture.line());
    assertEquals(List.of("main"), fixture.messages());
  }

  @Test
  void runToALineStopsThereOnce() {
    debugger.set(Breakpoint.at(6));
    fixture.start(CALLS).go();
    debugger.runTo(0, 8);
    fixture.go();
    assertEquals(8, fixture.line());
    assertEquals(
        Optional.of("line is 40, no statement begins there or after it"),
        DebugFixture.refusal(() -> debugger.runTo(0, 40)));
    fixture.resume();
    assertInstanceOf(Ending.Finished.class, fixture.ending());
  }

  @Test
  void theEndOfAThreadEndsItsStep() {
    debugger.set(Breakpoint.at(3));
    fixture
        .start(
            """
            def prog():
              thread short():
                textmsg("t")
              end
              h = run short()
              join h
              textmsg("end")
            end
            """)
        .go()
        .over();
    assertInstanceOf(Ending.Finished.class, fixture.ending());
    assertEquals(List.of("t", "end"), fixture.messages());
  }

  @Test
  void aThreadThatIsKilledWhileItStepsStopsNothing() {
    debugger.set(Breakpoint.at(3));
    fixture
        .start(
            """
            def prog():
              thread sleeper():
                sleep(10)
                textmsg("never")
              end
              h = run sleeper()
              sync()
              kill h
              textmsg("killed")
            end
            """)
        .go()
        .over();
    assertInstanceOf(Ending.Finished.class, fixture.ending());
    assertEquals(List.of("killed"), fixture.messages());
  }

  @Test
  void aStoppedThreadCanBeKilled() {
    debugger.set(Breakpoint.at(3));
    fixture
        .start(
            """
            def prog():
              thread worker():
                textmsg("never")
              end
              h = run worker()
              join h
              textmsg("end")
            end
            """)
        .go();
    debugger.kill(1);
    assertEquals(0, fixture.stop().thread());
    assertEquals(1, debugger.state().threads().size());
    assertEquals(
        Optional.of("thread 0 is the main thread, stop the program instead"),
        DebugFixture.refusal(() -> debugger.kill(0)));
    fixture.resume();
    assertEquals(List.of("end"), fixture.messages());
  }

  @Test
  void aPauseHoldsBetweenTwoFrames() {
    fixture.start("def prog():\n  sleep(0.1)\n  textmsg(1)\nend\n").advance(10);
    debugger.pause();
    assertFalse(fixture.advance());
    assertEquals(new PauseReason.PauseRequested(), fixture.stop().reason());
    assertEquals(2, fixture.line());
    assertEquals("sleep", fixture.thread(0).waitsFor());
    fixture.over();
    assertEquals(3, fixture.line());
    fixture.resume();
    assertEquals(51, fixture.frames);
  }

  @Test
  void requestsOutOfPlaceAreRefused() {
    assertEquals(Optional.of("no program is running"), DebugFixture.refusal(debugger::pause));
    assertEquals(
        Optional.of("the program is not paused"), DebugFixture.refusal(() -> debugger.stepOver(0)));
    debugger.set(Breakpoint.at(6));
    fixture.start(CALLS).go();
    assertEquals(
        Optional.of("the program is paused already"), DebugFixture.refusal(debugger::pause));
    assertEquals(
        Optional.of("there is no thread 7"), DebugFixture.refusal(() -> debugger.stepInto(7)));
    assertTrue(debugger.state().held());
  }

  @Test
  void interpretedLinesAreSteppedThrough() {
    debugger.set(Breakpoint.at(3));
    fixture
        .start(
            """
            def prog():
              def double(x):
                return x * 2
              end
              interpreter_mode()
              textmsg("left")
            end
            """)
        .advance(2);
    fixture.machine.interpreter().submit("b = double(1) c = b + 1");
    fixture.machine.interpreter().submit("textmsg(c)");
    fixture.machine.interpreter().submit("end_interpreter()");
    fixture.go();
    debugger.removeBreakpoints();
    fixture.into();
    assertEquals("interpreter:1", fixture.stack().getFirst());
    assertEquals("2", fixture.value("b"));
    fixture.over();
    assertEquals("3", fixture.value("c"));
    fixture.over();
    assertEquals(List.of("3"), fixture.messages());
    fixture.out();
    assertEquals(List.of("prog:6"), fixture.stack());
  }

  @Test
  void aFailingProgramIsHeldBeforeItEnds() {
    debugger.stopOnErrors(true);
    fixture
        .start(
            """
            def prog():
              def part(n):
                return 1 / n
              end
              x = 3
              part(0)
            end
            """)
        .go();
    PauseReason.Failed failed = assertInstanceOf(PauseReason.Failed.class, fixture.stop().reason());
    assertEquals(3, failed.failure().line());
    assertEquals(List.of("part:3", "prog:6"), fixture.stack());
    assertEquals("0", fixture.value("n"));
    assertEquals("4", fixture.value("x + 1"));
    assertEquals(
        Optional.of("the program has failed, it can only be ended"),
        DebugFixture.refusal(() -> debugger.stepOver(0)));
    fixture.resume();
    assertEquals(new Ending.Failed(failed.failure()), fixture.ending());
  }

  @Test
  void withoutTheWishForItAFailingProgramJustEnds() {
    fixture.start("def prog():\n  x = 1\n  x = x / (x - 1)\nend\n").go();
    assertInstanceOf(Ending.Failed.class, fixture.ending());
  }

  @Test
  void aThreadThatNeverWaitsIsKnown() {
    DebugFixture spins = new DebugFixture();
    spins.start("def prog():\n  i = 0\n  while True:\n    i = 1 - i\n  end\nend\n").advance(20);
    assertEquals(List.of(), spins.debugger.busyThreads(30));
    spins.advance(20);
    List<ThreadSnapshot> busy = spins.debugger.busyThreads(30);
    assertEquals(List.of(0), busy.stream().map(ThreadSnapshot::id).toList());
    assertEquals(4, busy.getFirst().line(), "in the loop, not before it");
  }

  @Test
  void aThreadThatWaitsAtTimesIsNotBusy() {
    DebugFixture waits = new DebugFixture();
    waits.start("def prog():\n  while True:\n    sync()\n  end\nend\n").advance(40);
    assertEquals(List.of(), waits.debugger.busyThreads(2));
  }
}
