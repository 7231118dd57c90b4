package org.pendant.testing.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.Debugger;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;

/** Tests that somebody else drives, with a debugger. */
class DebuggedTestTest {
  private static final int MOST_FRAMES = 20_000;
  private static final int LONG_LOOK = 2_000;

  private final List<Integer> stops = new ArrayList<>();

  /** Drives a test to its end; whoever looks at a stop takes longer than the test may wait. */
  private TestResult drive(DebuggedTest test, int breakpoint) {
    Controller controller = test.controller();
    var _ =
        controller.submit(
            new DebugCommand.Debug(debugger -> debugger.set(Breakpoint.at(breakpoint))));
    controller.applyCommands();
    test.begin(controller::submit);
    for (int i = 0; i < MOST_FRAMES; i++) {
      test.frames().advance();
      ControllerState state = controller.state();
      Optional<TestResult> result = test.after(state);
      if (result.isPresent()) {
        return result.get();
      }
      if (state.debug().held()) {
        stops.add(state.program().line());
        for (int look = 0; look < LONG_LOOK; look++) {
          test.frames().advance();
          assertTrue(test.after(controller.state()).isEmpty());
        }
        assertEquals(state.frame(), controller.state().frame());
        var _ = controller.submit(new DebugCommand.Debug(Debugger::resume));
      }
    }
    throw new AssertionError("the test does not end");
  }

  @Test
  void aTestStopsAtItsOwnBreakpointAndPassesAsItDoesWithoutOne() throws Exception {
    Suite suite =
        Suite.of("def test_a():", "  sleep(0.5)", "  a = 1", "  assert_equal(a, 1)", "end");
    DebuggedTest test = suite.debugged();

    TestResult result = drive(test, 3);

    assertEquals(List.of(3), stops);
    assertEquals(TestStatus.PASSED, result.status());
    assertEquals(suite.only().robotTimeS(), result.robotTimeS());
    assertEquals("cell/pick_test.script", test.file());
    assertEquals(3, test.lineInFile(3));
  }

  @Test
  void theProgramThatATestStartsStopsAndTheTestWaitsWithIt() throws Exception {
    Suite suite =
        Suite.of(
                "def test_a():",
                "  start(\"pick.script\")",
                "  eventually(get_standard_digital_out(0), within=0.3)",
                "  wait_for_end()",
                "end")
            .with(
                "cell/pick.script",
                "def pick():",
                "  sleep(0.1)",
                "  set_standard_digital_out(0, True)",
                "  sync()",
                "end");
    DebuggedTest test = suite.debugged();

    TestResult result = drive(test, 3);

    assertEquals("cell/pick.script", test.file());
    assertEquals(List.of(3), stops);
    assertEquals(Optional.empty(), result.failure());
    assertEquals(suite.only().robotTimeS(), result.robotTimeS());
  }

  @Test
  void theOtherControllersOfTheCellGoOnWithTheTestAndWaitWhereItStops() throws Exception {
    Suite suite =
        Suite.of(
                "# @scene ../cells/two.json",
                "def test_a():",
                "  start(\"pick.script\")",
                "  eventually(get_standard_digital_in(1), within=1)",
                "  wait_for_end()",
                "end")
            .with(
                "cell/pick.script",
                "def pick():",
                "  sleep(0.1)",
                "  set_standard_digital_out(0, True)",
                "  while not get_standard_digital_in(1):",
                "    sync()",
                "  end",
                "end")
            .with(
                "cells/answer.script",
                "def answer():",
                "  while not get_standard_digital_in(0):",
                "    sync()",
                "  end",
                "  sleep(0.2)",
                "  set_standard_digital_out(1, True)",
                "end")
            .with(
                "cells/two.json",
                "{\"arms\": [{\"name\": \"left\"},",
                " {\"name\": \"right\", \"base\": [1, 0, 0, 0, 0, 3], \"program\":"
                    + " \"answer.script\"}],",
                " \"wires\": [[\"left.digital_out[0]\", \"right.digital_in[0]\"],",
                "  [\"right.digital_out[1]\", \"left.digital_in[1]\"]]}");
    DebuggedTest test = suite.debugged();

    TestResult result = drive(test, 3);

    assertEquals(List.of(3), stops);
    assertEquals(Optional.empty(), result.failure());
    assertEquals(suite.only().robotTimeS(), result.robotTimeS());
  }

  @Test
  void aCellThatCannotBeIsRefused() {
    String why =
        refusal(
            Suite.of("# @scene ../cells/two.json", "def test_a():", "  sync()", "end")
                .with(
                    "cells/two.json",
                    "{\"arms\": [{\"name\": \"left\"},",
                    " {\"name\": \"right\", \"program\": \"none.script\"}]}"));
    assertTrue(why.contains("none.script"), why);
  }

  @Test
  void linesOfOtherFilesAreNoneOfItsOwn() throws Exception {
    DebuggedTest test =
        Suite.of("import_script(\"lib.script\")", "def test_a():", "  helper()", "end")
            .with("cell/lib.script", "def helper():", "  return 1", "end")
            .debugged();

    assertEquals(3, test.lineInFile(3));
    assertEquals(0, test.lineInFile(6));
  }

  @Test
  void aProgramThatIsNotKnownBeforehandIsRefused() {
    assertEquals(
        "it computes the name of the program that it starts; the debugger wants it in quotes",
        refusal(
            Suite.of("def test_a():", "  name = \"pick.script\"", "  start(name)", "end")
                .with("cell/pick.script", "sync()")));
    assertEquals(
        "start: cell/none.script: no such file",
        refusal(Suite.of("def test_a():", "  start(\"none.script\")", "end")));
  }

  private static String refusal(Suite suite) {
    return assertThrows(DebuggedTest.NotDebugged.class, suite::debugged).getMessage();
  }
}
