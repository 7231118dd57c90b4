package org.pendant.testing.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.ArmChoice;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.Value;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;
import org.pendant.testing.remote.TargetEvent;
import org.pendant.testing.remote.TargetState;
import org.pendant.testing.remote.TargetTrouble;

class TargetRunTest {
  private static final String FILE = "cell/pick_test.script";

  private final ScriptedTarget target = new ScriptedTarget();
  private final Map<String, String> files = new HashMap<>();
  private final List<String> told = new ArrayList<>();
  private TargetRunner runner;

  private SuiteResult run(String... lines) throws TargetTrouble {
    files.put(FILE, String.join("\n", lines) + "\n");
    files.put("cell/pick.script", "def pick():\n  set_standard_digital_out(0, True)\nend\n");
    TestSettings settings =
        new TestSettings(
            ControllerOptions.headless().withArm(ArmChoice.IDEAL),
            1,
            1,
            20,
            Duration.ofSeconds(60),
            false);
    runner =
        new TargetRunner(
            name -> {
              String text = files.get(name);
              if (text == null) {
                throw new IOException("no such file");
              }
              return text.getBytes(StandardCharsets.UTF_8);
            },
            settings,
            _ -> true,
            _ -> {});
    return runner.run(runner.plan(List.of(FILE)), target, () -> told.add("ready"));
  }

  private TestResult only(String... lines) throws TargetTrouble {
    SuiteResult result = run(lines);
    assertEquals(List.of(), result.broken());
    return result.results().getFirst();
  }

  private static TestFailure failure(TestResult result) {
    return result.failure().orElseThrow();
  }

  @Test
  void aTestSeesWhatItsProgramDoesAtTheTarget() throws TargetTrouble {
    target
        .then(new TargetEvent.Started())
        .then(new TargetEvent.Said("picked 1"))
        .after(100, TargetState.OUTPUTS, 1)
        .after(50, "actual_TCP_pose", 0.1, -0.3, 0.5, 0, 3, 0)
        .after(50, TargetState.OUTPUTS, 0)
        .then(new TargetEvent.Ended());

    TestResult result =
        only(
            "def test_pick():",
            "  start(\"pick.script\")",
            "  eventually(get_standard_digital_out(0), within=1)",
            "  on = robot_time()",
            "  eventually(not get_standard_digital_out(0), within=1)",
            "  assert_near(robot_time() - on, 0.2, 0.005)",
            "  wait_for_end()",
            "  assert_pose_near(get_actual_tcp_pose(), p[0.1, -0.3, 0.5, 0, 3, 0])",
            "  assert_true(tcp_inside([0, -1, 0], [1, 0, 1]))",
            "  assert_io_order([\"DO0 on\", \"DO0 off\"])",
            "  assert_log(\"picked\")",
            "end");

    assertEquals("", result.failure().map(TestFailure::message).orElse(""));
    assertTrue(result.output().getFirst().endsWith("picked 1"), result.output().toString());
    assertEquals(
        List.of(
            "watch 9", "begin", "def pick():\n  set_standard_digital_out(0, True)\nend\n", "end"),
        target.asked);
  }

  @Test
  void aTestWhoseArmIsToStandSomewhereAtFirstIsSkipped() throws TargetTrouble {
    assertEquals(
        "--target: `@start_at` puts the arm somewhere, which only Pendant's own controller can",
        only(
                "# @start_at 0, -90, -90, -90, 90, 0",
                "def test_it():",
                "  start(\"pick.script\")",
                "end")
            .skipped());
  }

  @Test
  void whatCannotBeDoneThereIsSkippedByNameBeforeAnythingStarts() throws TargetTrouble {
    BiConsumer<String, String> skips =
        (line, reason) -> {
          try {
            TestResult result =
                only(
                    "def helper():",
                    "  " + line,
                    "end",
                    "def test_it():",
                    "  start(\"pick.script\")",
                    "  helper()",
                    "end");
            assertEquals(TestStatus.SKIPPED, result.status());
            assertEquals("--target: " + reason, result.skipped());
          } catch (TargetTrouble e) {
            throw new AssertionError(e);
          }
        };
    skips.accept(
        "mock(\"pick\")", "`mock` replaces functions, which only Pendant's own controller can");
    skips.accept("wire(0, 5)", "`wire` sets an input, which only what is connected there does");
    skips.accept(
        "listen(5000)",
        "`listen` plays the computer at a socket in robot time, which only Pendant's own controller"
            + " can");
    skips.accept(
        "open_safeguard()",
        "`open_safeguard` does what people do at the robot, which none of its ports does");
    skips.accept(
        "set_standard_digital_out(1, True)",
        "`set_standard_digital_out` does something to the controller of the test, which is not the"
            + " target");
    skips.accept(
        "textmsg(get_joint_temp(0))", "`get_joint_temp` asks for what is not read of a target");
    assertFalse(target.asked.contains("begin"));
  }

  @Test
  void whatAnImportedFunctionCannotDoThereIsFoundBeforeAnythingStarts() throws TargetTrouble {
    files.put("cell/lib.script", "def lib():\n  set_standard_digital_out(1, True)\nend\n");

    TestResult result =
        only(
            "import_script(\"lib.script\")",
            "def test_it():",
            "  start(\"pick.script\")",
            "  lib()",
            "end");

    assertEquals(TestStatus.SKIPPED, result.status());
    assertFalse(target.asked.contains("begin"));
  }

  @Test
  void aTestIsNotSkippedForWhatOthersOfItsFileReplace() throws TargetTrouble {
    target.then(new TargetEvent.Started()).then(new TargetEvent.Ended());

    SuiteResult result =
        run(
            "def three():",
            "  return 3",
            "end",
            "def two():",
            "  return 2",
            "end",
            "def test_mocked():",
            "  mock(\"two\", three)",
            "  start(\"pick.script\")",
            "end",
            "def test_it():",
            "  start(\"pick.script\")",
            "  assert_equal(two(), 2)",
            "  wait_for_end()",
            "end");

    assertEquals(
        List.of(TestStatus.SKIPPED, TestStatus.PASSED),
        result.results().stream().map(TestResult::status).toList());
  }

  @Test
  void aProgramThatFailsThereIsToldWithTheLineOfItsFile() throws TargetTrouble {
    files.put("cell/two.script", "# comment\nx = 1\ntextmsg(x)\n");
    target
        .then(new TargetEvent.Started())
        .then(new TargetEvent.Failed(4, 3, "it went wrong"))
        .then(new TargetEvent.Ended());

    TestResult result =
        only(
            "def test_it():",
            "  start(\"two.script\")",
            "  eventually(not program_running(), within=2)",
            "end");

    assertEquals(TestStatus.ERROR, result.status());
    assertEquals("the program failed: it went wrong", failure(result).message());
    assertEquals("cell/two.script:3:1", failure(result).place().orElseThrow().text());
  }

  @Test
  void aProgramThatTheTargetRefusesHasFailed() throws TargetTrouble {
    target.then(new TargetEvent.Failed(1, 1, "compile_error_name_not_found:pock:"));

    TestResult result =
        only("def test_it():", "  start(\"pick.script\")", "  wait_for_end()", "end");

    assertEquals(TestStatus.FAILED, result.status());
    assertTrue(failure(result).message().contains("name_not_found:pock"));
  }

  @Test
  void aTargetThatIsLostMakesTheTestRedAndEndsTheSuite() throws TargetTrouble {
    target.then(new TargetEvent.Started()).isLost("it has closed the connection");

    SuiteResult result =
        run(
            "def test_a():",
            "  start(\"pick.script\")",
            "  wait_for_end()",
            "end",
            "def test_b():",
            "  start(\"pick.script\")",
            "end");

    assertEquals(1, result.results().size());
    assertEquals(1, result.notRun());
    TestResult red = result.results().getFirst();
    assertEquals(TestStatus.ERROR, red.status());
    assertEquals("the target: it has closed the connection", failure(red).message());
    assertEquals("end", target.asked.getLast());
  }

  @Test
  void aTargetThatIsNotReadyRunsNothing() {
    target.isNotReady("its robot mode is IDLE");

    TargetTrouble trouble =
        assertThrows(
            TargetTrouble.class, () -> run("def test_a():", "  start(\"pick.script\")", "end"));

    assertEquals("its robot mode is IDLE", trouble.getMessage());
    assertEquals(List.of(), told);
  }

  @Test
  void thatTheTargetIsReadyIsToldOnceBeforeAnythingStarts() throws TargetTrouble {
    target.then(new TargetEvent.Started()).then(new TargetEvent.Ended());
    target.after(1, () -> told.add("runs"));

    run(
        "def test_a():",
        "  start(\"pick.script\")",
        "  wait_for_end()",
        "end",
        "def test_b():",
        "  sleep(0.01)",
        "  if robot_time() > 100:",
        "    start(\"pick.script\")",
        "  end",
        "end");

    assertEquals(List.of("ready", "runs"), told);
  }

  @Test
  void anInterruptedTestIsRedAndItsProgramStoppedAndNoOtherBegins() throws TargetTrouble {
    target.then(new TargetEvent.Started()).after(50, () -> runner.cancel());

    SuiteResult result =
        run(
            "def test_a():",
            "  start(\"pick.script\")",
            "  wait_for_end()",
            "end",
            "def test_b():",
            "  start(\"pick.script\")",
            "end");

    TestResult red = result.results().getFirst();
    assertEquals(TestStatus.ERROR, red.status());
    assertEquals("interrupted, and stopped at the target", failure(red).message());
    assertEquals(0.1, red.robotTimeS(), 0.02);
    assertEquals(1, result.notRun());
    assertEquals("end", target.asked.getLast());
  }

  @Test
  void anInterruptedTestWhoseProgramDoesNotStopSaysSo() throws TargetTrouble {
    target
        .then(new TargetEvent.Started())
        .after(50, () -> runner.cancel())
        .cannotBeStopped("a program runs that does not stop");

    TestResult red = only("def test_a():", "  start(\"pick.script\")", "  wait_for_end()", "end");

    assertEquals(
        "interrupted, but what runs there could not be stopped: a program runs that does not stop",
        failure(red).message());
  }

  @Test
  void aSafetyStopIsRedUnlessTheTestWantsIt() throws TargetTrouble {
    target.then(new TargetEvent.Started()).after(10, TargetState.SAFETY_STATUS, 3);

    TestResult result =
        only(
            "def test_it():",
            "  start(\"pick.script\")",
            "  eventually(safety_mode() == \"protective_stop\")",
            "end");

    assertEquals("safety-stop", failure(result).code());
  }

  @Test
  void popupsAreClosedAndRegistersWrittenAtTheTarget() throws TargetTrouble {
    target
        .telling("input_int_register_3", 0)
        .then(new TargetEvent.Started())
        .then(new TargetEvent.PopupOpened(7, "Insert a part"))
        .after(20, "input_int_register_3", 42)
        .then(new TargetEvent.Ended());

    TestResult result =
        only(
            "def test_it():",
            "  write_input_integer_register(3, 42)",
            "  set_speed_slider(0.5)",
            "  start(\"pick.script\")",
            "  eventually(read_input_integer_register(3) == 42)",
            "  wait_for_end()",
            "end");

    assertEquals("", result.failure().map(TestFailure::message).orElse(""));
    String asked = String.join("\n", target.asked);
    assertTrue(asked.contains("IntegerRegister[direction=INPUT, address=3, value=42]"), asked);
    assertTrue(asked.contains("SetSpeedFraction"), asked);
    assertTrue(asked.contains("AnswerPopup[number=7]"), asked);
    assertTrue(asked.contains("watch 57"), asked);
  }

  @Test
  void aVariableIsWhatTheTargetTellsOfTheProgramOfThisTestAfterItIsAsked() throws TargetTrouble {
    target
        .telling(0, Map.of("count", Value.of(3)))
        .then(new TargetEvent.Started())
        .telling(20, Map.of())
        .telling(50, Map.of("count", Value.of(1)))
        .telling(50, Map.of("count", Value.of(2), "place", NumberList.of(0.1, 0.2)))
        .telling(50, Map.of("count", Value.of(3)))
        .then(new TargetEvent.Ended());

    TestResult result =
        only(
            "def test_it():",
            "  start(\"pick.script\")",
            "  assert_equal(program_variable(\"count\"), 1)",
            "  assert_equal(program_variable(\"place\"), [0.1, 0.2])",
            "  eventually(program_variable(\"count\") == 3, within=1)",
            "  wait_for_end()",
            "end");

    assertEquals("", result.failure().map(TestFailure::message).orElse(""));
  }

  @Test
  void aVariableThatTheTargetDoesNotTellIsToldAsThat() throws TargetTrouble {
    target.then(new TargetEvent.Started()).telling(50, Map.of("count", Value.of(1)));

    TestResult result =
        only(
            "def test_it():",
            "  start(\"pick.script\")",
            "  textmsg(program_variable(\"cuont\"))",
            "end");

    assertEquals(
        "program_variable: name is cuont, which is no global variable of the program that has"
            + " a value",
        failure(result).message());
  }

  @Test
  void aTargetThatTellsNoVariablesIsNotWaitedForLong() throws TargetTrouble {
    target.then(new TargetEvent.Started());

    TestResult result =
        only(
            "def test_it():",
            "  start(\"pick.script\")",
            "  textmsg(program_variable(\"count\"))",
            "end");

    assertEquals(
        "program_variable: the target tells no variables of a program of this test",
        failure(result).message());
    assertEquals(1, result.robotTimeS(), 0.1);
  }

  @Test
  void aTreeIsSentAsItsScriptAndItsErrorToldWithItsNode() throws TargetTrouble {
    files.put(
        "cell/boxes.pendant",
        """
        pendant program 1
        main
          script-line code="textmsg(1)"
          script-line code="textmsg(2)"
        """);
    target.then(new TargetEvent.Started()).after(1, () -> target.fail("textmsg(2)", "too far"));

    TestResult result =
        only(
            "def test_it():",
            "  start(\"boxes.pendant\")",
            "  eventually(not program_running(), within=2)",
            "end");

    assertEquals("node 3 \"textmsg(2)\": the program failed: too far", failure(result).message());
  }

  @Test
  void aProgramThatNeverEndsIsOutOfTimeByTheClockOfTheTarget() throws TargetTrouble {
    target.then(new TargetEvent.Started());

    TestResult result =
        only(
            "# @timeout 3",
            "def test_it():",
            "  start(\"pick.script\")",
            "  wait_for_end()",
            "end");

    assertEquals(TestStatus.TIMED_OUT, result.status());
    assertEquals(3, result.robotTimeS(), 0.01);
    assertEquals("end", target.asked.getLast());
  }

  @Test
  void aProgramThatDoesNotStartThereIsToldAsThat() throws TargetTrouble {
    TestResult result =
        only("def test_it():", "  start(\"pick.script\")", "  wait_for_end()", "end");

    assertEquals("the target has not started the program", failure(result).message());
  }
}
