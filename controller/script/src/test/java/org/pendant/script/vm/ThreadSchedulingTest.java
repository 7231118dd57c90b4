package org.pendant.script.vm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Threads, their order within a frame and their ends (manual 10). */
class ThreadSchedulingTest {
  private final MachineFixture fixture = new MachineFixture();

  @Test
  void theCallerGoesOnBeforeItsNewThreadBegins() {
    assertEquals(
        List.of("after run", "in thread", "end"),
        fixture.run(
            "def prog():",
            "  thread t():",
            "    textmsg(\"in thread\")",
            "  end",
            "  h = run t()",
            "  textmsg(\"after run\")",
            "  join h",
            "  textmsg(\"end\")",
            "end"));
    assertEquals(1, fixture.frames);
  }

  @Test
  void joinOfAThreadThatEndedHasNoEffect() {
    assertEquals(
        List.of("t", "end"),
        fixture.run(
            "def prog():",
            "  thread t():",
            "    textmsg(\"t\")",
            "  end",
            "  h = run t()",
            "  sync()",
            "  join h",
            "  join h",
            "  textmsg(\"end\")",
            "end"));
  }

  @Test
  void aKilledThreadTakesItsChildrenAlong() {
    assertEquals(
        List.of("3", "3"),
        fixture.run(
            "def prog():",
            "  a = 0",
            "  b = 0",
            "  thread outer():",
            "    thread inner():",
            "      while True:",
            "        b = b + 1",
            "        sync()",
            "      end",
            "    end",
            "    run inner()",
            "    while True:",
            "      a = a + 1",
            "      sync()",
            "    end",
            "  end",
            "  h = run outer()",
            "  frames(3)",
            "  kill h",
            "  kill h",
            "  frames(5)",
            "  textmsg(a)",
            "  textmsg(b)",
            "end"));
  }

  @Test
  void joiningAKilledThreadIsRefused() {
    ScriptFailure failure =
        fixture.fail(
            "def prog():",
            "  thread t():",
            "    while True:",
            "      sync()",
            "    end",
            "  end",
            "  h = run t()",
            "  kill h",
            "  join h",
            "end");
    assertEquals(9, failure.line());
    assertEquals("join: thread 1 was killed", failure.message());
  }

  @Test
  void onlyTheParentMayJoinAThread() {
    ScriptFailure failure =
        fixture.fail(
            "def prog():",
            "  thread worker():",
            "    frames(10)",
            "  end",
            "  thread other():",
            "    join h",
            "  end",
            "  h = run worker()",
            "  g = run other()",
            "  join g",
            "end");
    assertEquals("not-a-child", failure.code());
  }

  @Test
  void aHandleLivesInAnIntVariable() {
    assertEquals(
        List.of("t", "done"),
        fixture.run(
            "def prog():",
            "  h = -1",
            "  thread t():",
            "    textmsg(\"t\")",
            "  end",
            "  h = run t()",
            "  if h != -1:",
            "    join h",
            "  end",
            "  h = 0",
            "  textmsg(\"done\")",
            "end"));
  }

  @Test
  void noOtherThreadRunsInsideACriticalSectionThatComputesLongerThanAFrame() {
    assertEquals(
        List.of("critical done", "other"),
        fixture.run(
            "def prog():",
            "  thread other():",
            "    textmsg(\"other\")",
            "  end",
            "  enter_critical",
            "  h = run other()",
            "  i = 0",
            "  while i < 200000:",
            "    i = i + 1",
            "  end",
            "  textmsg(\"critical done\")",
            "  exit_critical",
            "  join h",
            "end"));
    assertTrue(fixture.frames > 1, "the loop fitted in one frame");
  }

  @Test
  void aWaitInsideACriticalSectionLetsOthersRun() {
    assertEquals(
        List.of("other", "critical done"),
        fixture.run(
            "def prog():",
            "  thread other():",
            "    textmsg(\"other\")",
            "  end",
            "  enter_critical",
            "  h = run other()",
            "  sync()",
            "  textmsg(\"critical done\")",
            "  exit_critical",
            "  join h",
            "end"));
  }

  @Test
  void anEndlessLoopHoldsNoFrame() {
    fixture.start(
        "def prog():",
        "  x = 0",
        "  thread t():",
        "    while True:",
        "      x = x + 1",
        "      sync()",
        "    end",
        "  end",
        "  run t()",
        "  while True:",
        "    y = 1",
        "  end",
        "end");
    fixture.advance(10);
    assertEquals(ProgramState.RUNNING, fixture.machine.state());
    assertEquals("10", fixture.machine.globals().get("x").text());
  }

  @Test
  void theProgramsEndKillsItsThreads() {
    fixture.run(
        "def prog():",
        "  thread t():",
        "    while True:",
        "      sync()",
        "      textmsg(\"alive\")",
        "    end",
        "  end",
        "  run t()",
        "end");
    assertInstanceOf(Ending.Finished.class, fixture.machine.ending().orElseThrow());
    assertEquals(List.of(), fixture.messages);
  }

  @Test
  void haltInAThreadEndsTheProgram() {
    fixture.start(
        "def prog():", "  thread t():", "    halt", "  end", "  run t()", "  frames(100)", "end");
    assertInstanceOf(Ending.Halted.class, fixture.finish());
    assertEquals(1, fixture.frames);
  }

  @Test
  void scriptTimeStandsStillWhilePaused() {
    fixture.start("def prog():", "  frames(5)", "end");
    fixture.advance(2);
    fixture.machine.pause();
    fixture.advance(50);
    fixture.machine.resume();
    fixture.finish();
    assertEquals(50 + 6, fixture.frames);
  }

  @Test
  void twoHundredThreadsRunBesideTheMainOneAndNoMore() {
    ScriptFailure failure =
        fixture.fail(
            "def prog():",
            "  thread t():",
            "    frames(500)",
            "  end",
            "  n = 0",
            "  while True:",
            "    run t()",
            "    n = n + 1",
            "    textmsg(n)",
            "  end",
            "end");
    assertEquals("too-many-threads", failure.code());
    assertEquals("200", fixture.messages.getLast());
  }

  @Test
  void recursionWithoutEndIsRefusedWithTheCallStack() {
    ScriptFailure failure =
        fixture.fail(
            "def prog():", "  def down(n):", "    return down(n + 1)", "  end", "  down(0)", "end");
    assertEquals("too-deep", failure.code());
    assertEquals(3, failure.line());
    assertEquals("prog", failure.stack().getLast().function());
    assertEquals(5, failure.stack().getLast().line());
  }

  @Test
  void aThreadThatCallsDeeplyKeepsItsValues() {
    assertEquals(
        List.of("20100", "20100"),
        fixture.run(
            "def prog():",
            "  def sum(n):",
            "    local a = n",
            "    local b = p[n, 0, 0, 0, 0, 0]",
            "    if n == 0:",
            "      return 0",
            "    end",
            "    local rest = sum(n - 1)",
            "    return rest + b[0]",
            "  end",
            "  thread t():",
            "    textmsg(sum(200))",
            "  end",
            "  h = run t()",
            "  textmsg(sum(200))",
            "  join h",
            "end"));
  }
}
