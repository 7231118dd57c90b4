package org.pendant.testing.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestPlace;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;

class TestRunTest {
  private static TestFailure failure(TestResult result) {
    return result.failure().orElseThrow();
  }

  @Test
  void aTestWhoseAssertionsHoldPasses() {
    TestResult result =
        Suite.of(
                "def test_sum():",
                "  assert_equal(1 + 2, 3)",
                "  assert_near(0.1 + 0.2, 0.3)",
                "end")
            .only();

    assertEquals(TestStatus.PASSED, result.status());
    assertEquals("test_sum", result.id().name());
  }

  @Test
  void anAssertionThatDoesNotHoldTellsItsPlaceAndBothValues() {
    TestResult result =
        Suite.of("def test_sum():", "  a = 1 + 1", "  assert_equal(a, 3, \"sum\")", "end").only();

    assertEquals(TestStatus.FAILED, result.status());
    assertEquals("sum: is 2, must be 3", failure(result).message());
    assertEquals(
        new TestPlace("cell/pick_test.script", 3, 3, "test_sum"),
        failure(result).place().orElseThrow());
  }

  @Test
  void aTestWatchesHowNearLinksComeToOneAnother() {
    TestResult result =
        Suite.of(
                "def test_fold():",
                "  assert_near(min_distance(), 0.0971, 0.001)",
                "  movej([0, -1.57, 2.6, 0, 0, 0], a=10, v=3)",
                "  assert_near(min_distance(), 0.0226, 0.001)",
                "end")
            .only();
    assertEquals(TestStatus.PASSED, result.status(), result::toString);
  }

  @Test
  void aTestCallsTheFunctionsInsideOfAnImportedProgram() {
    TestResult result =
        Suite.of(
                "import_script(\"pick.script\")",
                "def test_height():",
                "  assert_near(height_of(3), 0.15)",
                "end")
            .with(
                "cell/pick.script",
                "def pick():",
                "  part = 0.05",
                "  def height_of(n):",
                "    return n * part",
                "  end",
                "  movej([0, -1.57, 0, -1.57, 0, 0])",
                "end")
            .only();

    assertEquals(Optional.empty(), result.failure());
    assertEquals(TestStatus.PASSED, result.status());
  }

  @Test
  void aFailureInAnImportedFunctionIsToldWithItsPlaceThereAndTheCallInTheTest() {
    TestResult result =
        Suite.of(
                "import_script(\"pick.script\")", "def test_height():", "  x = height_of(0)", "end")
            .with(
                "cell/pick.script",
                "def height_of(n):",
                "  return 1 / n",
                "end",
                "def pick():",
                "  sync()",
                "end")
            .only();

    assertEquals(TestStatus.ERROR, result.status());
    assertTrue(
        failure(result).place().orElseThrow().text().startsWith("cell/pick.script:2:"),
        failure(result).place().orElseThrow().text());
    assertTrue(
        failure(result)
            .stack()
            .contains(new TestPlace("cell/pick_test.script", 3, 0, "test_height")));
  }

  @Test
  void aTestWatchesTheProgramThatItStarts() {
    TestResult result =
        Suite.of(
                "def test_grips():",
                "  wire(0, 1, delay=0.4)",
                "  start(\"pick.script\")",
                "  eventually(get_standard_digital_out(0), within=1)",
                "  before = robot_time()",
                "  eventually(get_standard_digital_out(7), within=1)",
                "  assert_near(robot_time() - before, 0.4, 0.01)",
                "  wait_for_end(within=5)",
                "  assert_equal(program_variable(\"parts\"), 1)",
                "end")
            .with(
                "cell/pick.script",
                "def pick():",
                "  global parts = 0",
                "  sleep(0.1)",
                "  set_standard_digital_out(0, True)",
                "  while not get_standard_digital_in(1):",
                "    sync()",
                "  end",
                "  parts = parts + 1",
                "  set_standard_digital_out(7, True)",
                "  sleep(0.1)",
                "end")
            .only();

    assertEquals(Optional.empty(), result.failure());
    assertEquals(TestStatus.PASSED, result.status());
  }

  @Test
  void whatDoesNotBecomeTrueInTimeFailsTheTest() {
    TestResult result =
        Suite.of(
                "def test_never():", "  eventually(get_standard_digital_out(3), within=0.5)", "end")
            .only();

    assertEquals(TestStatus.FAILED, result.status());
    assertEquals(
        "eventually: get_standard_digital_out(3) did not become True in time",
        failure(result).message());
    assertEquals((0.5 + 0.51) / 2, result.robotTimeS(), (0.51 - 0.5) / 2);
  }

  @Test
  void whatMustAlwaysHoldFailsTheTestInTheFrameInWhichItDoesNot() {
    TestResult result =
        Suite.of(
                "def test_stays():",
                "  start(\"blink.script\")",
                "  never(get_standard_digital_out(2), message=\"lamp\")",
                "end")
            .with(
                "cell/blink.script",
                "def blink():",
                "  sleep(0.2)",
                "  set_standard_digital_out(2, True)",
                "  sleep(0.2)",
                "end")
            .only();

    assertEquals("lamp: get_standard_digital_out(2) became True", failure(result).message());
    assertEquals((0.2 + 0.22) / 2, result.robotTimeS(), (0.22 - 0.2) / 2);
  }

  @Test
  void whatDoesNotComeAboutIsSaidInASentenceOfItsOwn() {
    assertEquals("always: 1 > 2 was not True any more", messageOf("always(1 > 2, during=0.1)"));
    assertEquals(
        "peer_expect: \"shot\" did not come in time; nothing came",
        messageOf("listen(5000)\n  peer_expect(5000, \"shot\", within=0.1)"));
    assertEquals(
        "assert_io_order: DO0 on did not come; nothing changed",
        messageOf("assert_io_order([\"DO0 on\"])"));
    assertEquals(
        "wait_for_end: the program still runs after 0.1 s",
        messageOf("start(\"wait.script\")\n  wait_for_end(0.1)"));
    assertEquals(
        "wait_for_end: the program is paused after 0.1 s",
        messageOf("start(\"wait.script\")\n  pause_program()\n  wait_for_end(0.1)"));
    String other = messageOf("start(\"fail.script\")\n  assert_program_fails(\"part\")");
    assertTrue(other.startsWith("assert_program_fails: the program failed in line 3: "), other);
    assertTrue(other.endsWith("; the message must contain part"), other);
  }

  private static String messageOf(String statements) {
    TestResult result =
        Suite.of("def test_it():", "  " + statements, "end")
            .with("cell/wait.script", "def wait():", "  sleep(9)", "end")
            .with("cell/fail.script", "def fails():", "  x = [1, 2]", "  y = x[5]", "end")
            .only();
    return failure(result).message();
  }

  @Test
  void aProgramThatFailsUnwatchedMakesTheTestRed() {
    TestResult result =
        Suite.of("def test_runs():", "  start(\"bad.script\")", "  sleep(0.5)", "end")
            .with("cell/bad.script", "def bad():", "  x = [1]", "  y = x[3]", "end")
            .only();

    assertEquals(TestStatus.ERROR, result.status());
    assertTrue(
        failure(result).message().startsWith("the program failed: "), failure(result).message());
    assertTrue(
        failure(result).place().orElseThrow().text().startsWith("cell/bad.script:3:"),
        failure(result).place().orElseThrow().text());
  }

  @Test
  void aProgramMayFailWhereTheTestWantsThat() {
    TestResult result =
        Suite.of(
                "def test_fails():",
                "  start(\"bad.script\")",
                "  assert_program_fails(\"index\")",
                "end")
            .with("cell/bad.script", "def bad():", "  x = [1]", "  y = x[3]", "end")
            .only();

    assertEquals(Optional.empty(), result.failure());
  }

  @Test
  void aMockAnswersInPlaceOfABuiltinAndOfAFunctionOfTheProgram() {
    TestResult result =
        Suite.of(
                "def test_mocks():",
                "  mock(\"get_standard_analog_in\", [0.2, 0.9])",
                "  mock(\"grip\", True)",
                "  start(\"pick.script\")",
                "  wait_for_end()",
                "  assert_equal(program_variable(\"first\"), 0.2)",
                "  assert_equal(program_variable(\"second\"), 0.9)",
                "  assert_equal(program_variable(\"held\"), True)",
                "  assert_equal(mock_calls(\"grip\"), 1)",
                "  assert_equal(mock_argument(\"grip\", 0), 40)",
                "end")
            .with(
                "cell/pick.script",
                "def pick():",
                "  def grip(force):",
                "    sleep(100)",
                "    return False",
                "  end",
                "  global first = get_standard_analog_in(0)",
                "  global second = get_standard_analog_in(0)",
                "  global held = grip(40)",
                "end")
            .only();

    assertEquals(Optional.empty(), result.failure());
    assertEquals(TestStatus.PASSED, result.status());
  }

  @Test
  void aMockOfAFunctionThatThereIsNotMakesTheTestRed() {
    TestResult result = Suite.of("def test_mocks():", "  mock(\"gripp\", True)", "end").only();

    assertEquals(TestStatus.FAILED, result.status());
    assertTrue(
        failure(result).message().startsWith("mock: there is no function gripp"),
        failure(result).message());
  }

  @Test
  void aTestThatNeverEndsIsStoppedWhenItsRobotTimeIsUp() {
    TestResult result =
        Suite.of("# @timeout 2", "def test_hangs():", "  while True:", "    sync()", "  end", "end")
            .only();

    assertEquals(TestStatus.TIMED_OUT, result.status());
    assertEquals((1.99 + 2.01) / 2, result.robotTimeS(), (2.01 - 1.99) / 2);
  }

  @Test
  void aTableOfCasesIsATestForEachRow() {
    var result =
        Suite.of(
                "# @case 1, 2",
                "# @case 2, 5",
                "def test_double(n, expected):",
                "  assert_equal(2 * n, expected)",
                "end")
            .run();

    assertEquals(
        List.of("test_double[1, 2] PASSED", "test_double[2, 5] FAILED"),
        result.results().stream().map(each -> each.id().name() + " " + each.status()).toList());
  }

  @Test
  void aSkippedTestTellsWhy() {
    var result =
        Suite.of(
                "# @skip no gripper yet",
                "def test_grip():",
                "  fail()",
                "end",
                "def test_other():",
                "  skip(\"later\")",
                "end")
            .run();

    assertEquals(
        List.of("SKIPPED no gripper yet", "SKIPPED later"),
        result.results().stream().map(each -> each.status() + " " + each.skipped()).toList());
  }

  @Test
  void popupsCloseByThemselvesAndQuestionsGetThePreparedAnswer() {
    TestResult result =
        Suite.of(
                "def test_asks():",
                "  answer(\"How many\", 3)",
                "  start(\"ask.script\")",
                "  wait_for_end()",
                "  assert_equal(program_variable(\"n\"), 3)",
                "  assert_log(\"counted\")",
                "end")
            .with(
                "cell/ask.script",
                "def ask():",
                "  popup(\"ready\", blocking=True)",
                "  global n = request_integer_from_primary_client(\"How many?\")",
                "  textmsg(\"counted \", n)",
                "end")
            .only();

    assertEquals(Optional.empty(), result.failure());
    assertTrue(result.output().stream().anyMatch(line -> line.endsWith("counted 3")));
  }

  @Test
  void anAnswerComesAsLongAfterTheQuestionAsTheOperatorThinks() {
    TestResult result =
        Suite.of(
                "def test_asks():",
                "  answer(\"How many\", 3, after=0.5)",
                "  answer(\"Sure\", True)",
                "  start(\"ask.script\")",
                "  wait_for_end()",
                "  assert_near(program_variable(\"thought\"), 0.5)",
                "  assert_near(program_variable(\"said\"), 0.002)",
                "end")
            .with(
                "cell/ask.script",
                "def ask():",
                "  global frames = 0",
                "  thread count():",
                "    while True:",
                "      frames = frames + 1",
                "      sync()",
                "    end",
                "  end",
                "  run count()",
                "  from = frames",
                "  request_integer_from_primary_client(\"How many?\")",
                "  global thought = (frames - from) * 0.002",
                "  from = frames",
                "  request_boolean_from_primary_client(\"Sure?\")",
                "  global said = (frames - from) * 0.002",
                "end")
            .only();

    assertEquals(Optional.empty(), result.failure());
  }

  @Test
  void theArmStandsWhereTheMarkSaysAtFirst() {
    TestResult result =
        Suite.of(
                "# @start_at 10, -80, -90, -90, 90, 0.5",
                "def test_place():",
                "  assert_joints_near(get_actual_joint_positions(),"
                    + " [d2r(10), d2r(-80), d2r(-90), d2r(-90), d2r(90), d2r(0.5)], deg=0.001)",
                "end")
            .only();

    assertEquals(Optional.empty(), result.failure());
  }

  @Test
  void aSafetyStopThatNobodyExpectsMakesTheTestRed() {
    TestResult result =
        Suite.of("def test_stops():", "  start(\"stop.script\")", "  sleep(1)", "end")
            .with("cell/stop.script", "def stop():", "  protective_stop()", "  sleep(5)", "end")
            .only();

    assertEquals(TestStatus.ERROR, result.status());
    assertEquals("safety-stop", failure(result).code());
  }

  @Test
  void aTreeRunsInTheInstallationThatItNames() throws IOException {
    Path examples = Path.of("../../examples");

    TestResult result =
        Suite.of(
                "def test_stacks():",
                "  start(\"stack_boxes.pendant\")",
                "  wait_for_end(within=100)",
                "  assert_log(\"tray is full, boxes: 6\")",
                "end")
            .with(
                "cell/stack_boxes.pendant",
                Files.readString(examples.resolve("stack_boxes.pendant")))
            .with("cell/stack_boxes.pinst", Files.readString(examples.resolve("stack_boxes.pinst")))
            .only();

    assertEquals(Optional.empty(), result.failure());
  }

  @Test
  void changesOfSignalsHaveAnOrder() {
    String program =
        """
        def pick():
          set_standard_digital_out(0, True)
          sleep(0.5)
          set_standard_digital_out(0, False)
          sleep(0.1)
        end
        """;
    Suite suite =
        Suite.of(
                "def run_it():",
                "  wire(0, 5, delay=0.2)",
                "  start(\"pick.script\")",
                "  wait_for_end()",
                "end",
                "def test_order():",
                "  run_it()",
                "  assert_io_order([\"DO0 on\", \"DI5 on\", \"do0 off\"])",
                "end",
                "def test_wrong():",
                "  run_it()",
                "  assert_io_order([\"DI5 on\", \"DO0 on\"])",
                "end")
            .with("cell/pick.script", program);

    List<TestResult> results = suite.run().results();

    assertEquals(TestStatus.PASSED, results.getFirst().status());
    String message = failure(results.getLast()).message();
    assertTrue(
        message.startsWith("assert_io_order: after DI5 on DO0 on did not come; DO0 on at 0.0"),
        message);
  }

  @Test
  void onlyProgramsAreStarted() {
    TestResult result =
        Suite.of("def test_reads():", "  start(\"../secret.txt\")", "end")
            .with("secret.txt", "password")
            .only();

    assertEquals(
        "start: secret.txt is no program, whose name ends with .script, .pendant, .urp",
        failure(result).message());
  }
}
