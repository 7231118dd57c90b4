package org.pendant.script.vm;

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

  private void mode(String... lines) {
    for (String line : lines) {
      assertTrue(fixture.submit(line).startsWith("ack "), line);
    }
    fixture.submit("end_interpreter()");
    fixture.advance(4);
  }

  @Test
  void whatAModeKeepsIsThereInLaterOnes() {
    fixture.start(
        "def prog():",
        "  a = 1",
        "  interpreter_mode(clearOnEnd = False)",
        "  def busy(x, y, z):",
        "    local l = [x, y, z, x, y, z, x, y, z]",
        "    return l[0]",
        "  end",
        "  textmsg(\"between \", busy(7, 8, 9))",
        "  interpreter_mode(clearOnEnd = False)",
        "  interpreter_mode()",
        "end");
    fixture.advance(2);
    mode("def keep(x): return x + a end", "b = [1, 2]", "thread t(): a = a + 1 end", "c = 4");
    mode("textmsg(b, keep(3))", "b[0] = 5", "b = [b[0], c]", "d = keep(0)", "run t()");
    mode("textmsg(b, d)", "textmsg(keep(0))");
    assertInstanceOf(Ending.Finished.class, fixture.finish());
    assertEquals(List.of("between 7", "[1, 2]4", "[5, 4]1", "2"), fixture.messages);
  }

  @Test
  void onlyWhatTheModeItselfHasAddedIsClearedAtItsEnd() {
    fixture.start(
        "def prog():",
        "  interpreter_mode(clearOnEnd = False)",
        "  interpreter_mode()",
        "  interpreter_mode()",
        "end");
    fixture.advance(2);
    mode("kept = 1", "def keep(): return 10 end");
    mode("kept = 2", "fresh = 3", "def gone(): return 4 end", "textmsg(kept + fresh, gone())");
    assertEquals("discard variable fresh is never assigned", fixture.submit("textmsg(fresh)"));
    assertEquals("discard function gone is not defined", fixture.submit("gone()"));
    mode("fresh = 5", "textmsg(kept + fresh, keep())");
    assertEquals(List.of("54", "710"), fixture.messages);
  }

  @Test
  void clearingLeavesWhatEarlierModesHaveKept() {
    fixture.start(
        "def prog():",
        "  interpreter_mode(clearOnEnd = False)",
        "  interpreter_mode(clearOnEnd = False)",
        "  interpreter_mode()",
        "end");
    fixture.advance(2);
    mode("kept = 1");
    fixture.submit("kept = 2");
    fixture.submit("fresh = 3");
    fixture.submit("clear_interpreter()");
    fixture.advance(2);
    assertTrue(fixture.submit("textmsg(fresh)").startsWith("discard "));
    mode("textmsg(kept)", "other = 7");
    mode("textmsg(kept, other)");
    assertEquals(List.of("2", "27"), fixture.messages);
  }

  @Test
  void whatIsKeptGoesAlongIntoAnotherFunction() {
    fixture.start(
        "def prog():",
        "  global g = 1",
        "  interpreter_mode(clearOnEnd = False)",
        "  def work(x):",
        "    local kept = 100",
        "    local y = x",
        "    interpreter_mode()",
        "    return kept + y",
        "  end",
        "  textmsg(work(3))",
        "end");
    fixture.advance(2);
    mode("kept = 1", "also = 2", "def keep(x): return x * g end");
    mode("g = 10", "textmsg(kept, also)", "y = keep(also + x)", "kept = kept + 1");
    assertInstanceOf(Ending.Finished.class, fixture.finish());
    assertEquals(List.of("1002", "151"), fixture.messages);
  }

  @Test
  void linesBetweenTheModesRunInTheNextOneThatKeepsItsQueue() {
    fixture.start(
        "def prog():",
        "  interpreter_mode(clearOnEnd = False)",
        "  frames(3)",
        "  interpreter_mode(clearQueueOnEnter = False)",
        "end");
    fixture.advance(2);
    fixture.submit("def keep(): return 6 end");
    fixture.submit("end_interpreter()");
    fixture.submit("b = keep()");
    fixture.advance(2);
    assertFalse(fixture.machine.interpreter().active());
    assertEquals("ack 4", fixture.submit("textmsg(keep(), b)"));
    fixture.submit("end_interpreter()");
    assertInstanceOf(Ending.Finished.class, fixture.finish());
    assertEquals(List.of("66"), fixture.messages);
  }

  @Test
  void variablesStayWhenTheMemoryIsCountedBetweenTwoLines() {
    fixture.start(
        "def prog():",
        "  thread filler():",
        "    local s = \"0123456789abcdef\"",
        "    local i = 0",
        "    while i < 15:",
        "      s = s + s",
        "      i = i + 1",
        "    end",
        "    local l = [s]",
        "    while True:",
        "      l[0] = \"y\" + s",
        "      sync()",
        "    end",
        "  end",
        "  run filler()",
        "  interpreter_mode()",
        "end");
    fixture.advance(2);
    fixture.submit("b = [1, 2]");
    fixture.advance(1000);
    fixture.submit("textmsg(b)");
    fixture.advance(2);
    assertEquals(List.of("[1, 2]"), fixture.messages);
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
