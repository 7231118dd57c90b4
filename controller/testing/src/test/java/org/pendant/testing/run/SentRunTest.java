package org.pendant.testing.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.ArmChoice;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;
import org.pendant.testing.remote.TargetEvent;
import org.pendant.testing.remote.TargetState;
import org.pendant.testing.remote.TargetTrouble;

/** Tests that start no program, at a target that tells what the test there would. */
class SentRunTest {
  private static final String FILE = "cell/sum_test.script";

  private final ScriptedTarget target = new ScriptedTarget();
  private final Map<String, String> files = new HashMap<>();

  private TestResult run(String... lines) throws TargetTrouble {
    files.put(FILE, String.join("\n", lines) + "\n");
    TargetRunner runner =
        new TargetRunner(
            name -> {
              String text = files.get(name);
              if (text == null) {
                throw new IOException("no such file");
              }
              return text.getBytes(StandardCharsets.UTF_8);
            },
            new TestSettings(
                ControllerOptions.headless().withArm(ArmChoice.IDEAL),
                1,
                1,
                20,
                Duration.ofSeconds(60),
                false),
            _ -> true,
            _ -> {});
    var result = runner.run(runner.plan(List.of(FILE)), target, () -> {});
    assertEquals(List.of(), result.broken());
    return result.results().getFirst();
  }

  private static String message(TestResult result) {
    return result.failure().map(TestFailure::message).orElse("");
  }

  private static String place(TestResult result) {
    return result.failure().orElseThrow().place().orElseThrow().text();
  }

  private void tells(String... what) {
    target.then(new TargetEvent.Started());
    for (String each : what) {
      target.after(1, () -> target.tell(each));
    }
    target.then(new TargetEvent.Ended());
  }

  @Test
  void aTestThatTellsItsEndHasPassedAndWhatItTellsIsNoOutput() throws TargetTrouble {
    target.then(new TargetEvent.Started()).then(new TargetEvent.Said("sum"));
    target.after(1, () -> target.tell("done 0 ")).then(new TargetEvent.Ended());

    TestResult result =
        run("def test_sum():", "  textmsg(\"sum\")", "  assert_equal(1 + 1, 2)", "end");

    assertEquals(TestStatus.PASSED, result.status());
    assertEquals(1, result.output().size());
  }

  @Test
  void anAssertionThatFailsThereIsToldWithItsLine() throws TargetTrouble {
    tells("failed 2 assert_equal: is 2, must be 3");

    TestResult result = run("def test_sum():", "  assert_equal(1 + 1, 3)", "end");

    assertEquals(TestStatus.FAILED, result.status());
    assertEquals("assert_equal: is 2, must be 3", message(result));
    assertEquals("cell/sum_test.script:2:3", place(result));
  }

  @Test
  void aTestThatSkipsItselfIsSkipped() throws TargetTrouble {
    tells("skipped 2 no gripper");

    assertEquals("no gripper", run("def test_sum():", "  skip(\"no gripper\")", "end").skipped());
  }

  @Test
  void anErrorThatIsExpectedIsWhatTheTestWants() throws TargetTrouble {
    target.then(new TargetEvent.Started()).after(1, () -> target.tell("expects 2 index is 5"));
    target.after(1, () -> target.fail("a[5]", "index is 5, must be 0 to 1"));

    TestResult result =
        run(
            "def test_index():",
            "  expect_failure(\"index is 5\")",
            "  a = [1, 2]",
            "  textmsg(a[5])",
            "end");

    assertEquals("", message(result));
  }

  @Test
  void anErrorIsToldWithThePlaceInTheFileThatItIsIn() throws TargetTrouble {
    files.put("cell/lib.script", "# first\ndef lib(a):\n  return a[5]\nend\n");
    target
        .then(new TargetEvent.Started())
        .after(1, () -> target.fail("a[5]", "index is 5, must be 0 to 1"));

    TestResult result =
        run("import_script(\"lib.script\")", "def test_it():", "  textmsg(lib([1]))", "end");

    assertEquals("index is 5, must be 0 to 1", message(result));
    assertEquals("cell/lib.script:3:3", place(result));
  }

  @Test
  void aTestThatEndsThereWithoutAWordWasStopped() throws TargetTrouble {
    tells();

    assertEquals(
        "the test was stopped at the target before it came to its end",
        message(run("def test_it():", "  sleep(1)", "end")));
  }

  @Test
  void aSafetyStopEndsTheTest() throws TargetTrouble {
    target
        .then(new TargetEvent.Started())
        .after(10, TargetState.SAFETY_STATUS, 3)
        .after(0, TargetState.RUN_STATE, 4);

    assertEquals(
        "the safety functions have stopped the arm: protective_stop",
        message(run("def test_it():", "  sleep(10)", "end")));
  }

  @Test
  void whatWatchesAProgramCannotBeSent() throws TargetTrouble {
    assertEquals(
        "--target: `eventually` is for tests that start a program there; this one is sent as a"
            + " whole",
        run("def test_it():", "  eventually(get_standard_digital_out(0))", "end").skipped());
    assertEquals(
        "--target: `mock` replaces functions, which only Pendant's own controller can",
        run("def test_it():", "  mock(\"sleep\")", "end").skipped());
    assertFalse(target.asked.contains("begin"));
  }
}
