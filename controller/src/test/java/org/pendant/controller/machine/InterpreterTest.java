package org.pendant.controller.machine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Interpreter mode (manual 13). */
class InterpreterTest {
  private final MachineFixture fixture = new MachineFixture();

  private MachineFixture interpreting() {
    return fixture
        .start("def prog():", "  a = 1", "  interpreter_mode()", "  textmsg(\"left \", a)", "end")
        .advance(2);
  }

  @Test
  void linesAreNumberedAndRunInTheScopeOfTheCaller() {
    interpreting();
    assertEquals("ack 1", fixture.submit("a = a + 1"));
    assertEquals("ack 2", fixture.submit("textmsg(\"a is \", a) textmsg(\"again\")"));
    fixture.advance(1);
    assertEquals(List.of("a is 2", "again"), fixture.messages);
    assertEquals(2, fixture.machine.interpreter().lastExecuted());
  }

  @Test
  void theProgramGoesOnBehindTheCallWhenTheModeEnds() {
    interpreting();
    fixture.submit("a = 7");
    fixture.submit("end_interpreter()");
    assertInstanceOf(Ending.Finished.class, fixture.finish());
    assertEquals(List.of("left 7"), fixture.messages);
  }

  @Test
  void functionsAndVariablesStayForLaterLines() {
    interpreting();
    fixture.submit("def double(x): return x * 2 end");
    fixture.submit("b = double(21)");
    fixture.submit("textmsg(b)");
    fixture.advance(1);
    assertEquals(List.of("42"), fixture.messages);
  }

  @Test
  void aLineThatDoesNotCompileIsDiscardedWhole() {
    interpreting();
    assertTrue(fixture.submit("a = 5 textmsg(nothing)").startsWith("discard "));
    assertTrue(fixture.submit("foo(").startsWith("discard "));
    assertEquals("ack 1", fixture.submit("textmsg(a)"));
    fixture.advance(1);
    assertEquals(List.of("1"), fixture.messages);
  }

  @Test
  void newGlobalsAndNestedModesAreRefused() {
    interpreting();
    assertTrue(fixture.submit("global fresh = 1").startsWith("discard "));
    assertTrue(fixture.submit("interpreter_mode()").startsWith("discard "));
  }

  @Test
  void nothingIsTakenWithoutAProgram() {
    assertEquals("discard no program is running", fixture.submit("textmsg(1)"));
  }

  @Test
  void skipDropsWhatHasNotBegun() {
    interpreting();
    fixture.submit("frames(5)");
    fixture.submit("textmsg(\"never\")");
    fixture.advance(1);
    assertEquals(1, fixture.machine.interpreter().unexecuted());
    fixture.machine.interpreter().skip();
    fixture.submit("textmsg(\"next\")");
    fixture.advance(10);
    assertEquals(List.of("next"), fixture.messages);
  }

  @Test
  void clearForgetsFunctionsAndStopsThreads() {
    interpreting();
    fixture.submit("thread t(): while True: a = a + 1 sync() end end");
    fixture.submit("h = run t()");
    fixture.advance(3);
    fixture.submit("clear_interpreter()");
    fixture.advance(2);
    String stopped = fixture.machine.globals().get("a").text();
    fixture.advance(5);
    assertEquals(stopped, fixture.machine.globals().get("a").text());
    assertEquals(3, fixture.machine.interpreter().lastCleared());
    assertTrue(fixture.submit("run t()").startsWith("discard "));
  }

  @Test
  void queuedLinesRunOnEntryWhenTheQueueIsKept() {
    fixture.start(
        "def prog():", "  frames(2)", "  interpreter_mode(clearQueueOnEnter = False)", "end");
    fixture.advance(1);
    assertEquals("ack 1", fixture.submit("textmsg(\"early\")"));
    assertFalse(fixture.machine.interpreter().active());
    fixture.advance(5);
    assertEquals(List.of("early"), fixture.messages);
  }

  @Test
  void queuedLinesAreDroppedOnEntryByDefault() {
    fixture.start("def prog():", "  frames(2)", "  interpreter_mode()", "end");
    fixture.advance(1);
    fixture.submit("textmsg(\"early\")");
    fixture.advance(5);
    assertEquals(List.of(), fixture.messages);
  }

  @Test
  void linesInsideAFunctionSeeItsLocals() {
    fixture.start(
        "def prog():",
        "  def work(x):",
        "    local y = x + 1",
        "    interpreter_mode()",
        "    return y",
        "  end",
        "  textmsg(100 + work(1))",
        "end");
    fixture.advance(2);
    fixture.submit("z = y * 10");
    fixture.submit("y = z + x");
    fixture.submit("end_interpreter()");
    fixture.finish();
    assertEquals(List.of("121"), fixture.messages);
  }

  @Test
  void aRuntimeErrorInALineStopsTheProgram() {
    interpreting();
    fixture.submit("a = 1 / 0");
    assertInstanceOf(Ending.Failed.class, fixture.finish());
  }
}
