package org.pendant.testing.run;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;

class MockByFunctionTest {
  private static final String[] PICK = {
    "def pick():",
    "  def grip(force, width=0.1):",
    "    sleep(100)",
    "    return 0",
    "  end",
    "  global weak = grip(10)",
    "  global strong = grip(40, 0.05)",
    "end"
  };

  private static void passes(TestResult result) {
    assertEquals(Optional.empty(), result.failure());
    assertEquals(TestStatus.PASSED, result.status());
  }

  @Test
  void aFunctionOfTheTestAnswersForOneOfTheProgramAndGetsItsArguments() {
    passes(
        Suite.of(
                "held = 0",
                "def hold(force, width):",
                "  held = held + 1",
                "  return force * width",
                "end",
                "def test_grips():",
                "  mock_by(\"grip\", \"hold\")",
                "  start(\"pick.script\")",
                "  wait_for_end()",
                "  assert_near(program_variable(\"weak\"), 1)",
                "  assert_near(program_variable(\"strong\"), 2)",
                "  assert_equal(held, 2)",
                "  assert_equal(mock_calls(\"grip\"), 2)",
                "  assert_equal(mock_argument(\"grip\", 1), 40)",
                "  assert_true(robot_time() < 0.1)",
                "end")
            .with("cell/pick.script", PICK)
            .only());
  }

  @Test
  void aFunctionAnswersForABuiltinThatAnImportedFunctionCallsAndTakesItsTime() {
    passes(
        Suite.of(
                "import_script(\"wait.script\")",
                "reads = 0",
                "def level(n):",
                "  reads = reads + 1",
                "  sleep(0.1)",
                "  return n == 3 and reads == 4",
                "end",
                "def test_waits():",
                "  mock_by(\"get_standard_digital_in\", \"level\")",
                "  assert_equal(looks(3), 4)",
                "  assert_true(robot_time() > 0.4)",
                "  unmock(\"get_standard_digital_in\")",
                "  assert_false(get_standard_digital_in(3))",
                "end")
            .with(
                "cell/wait.script",
                "def looks(input):",
                "  n = 1",
                "  while not get_standard_digital_in(input):",
                "    n = n + 1",
                "  end",
                "  return n",
                "end")
            .only());
  }

  @Test
  void aFunctionTakesAsManyArgumentsAsItWantsAndNeedNotAnswer() {
    passes(
        Suite.of(
                "moved = 0",
                "def note(q):",
                "  moved = moved + q[0]",
                "end",
                "def test_moves():",
                "  mock_by(\"movej\", \"note\")",
                "  movej([0.5, 0, 0, 0, 0, 0], a=1, v=2)",
                "  movej([0.25, 0, 0, 0, 0, 0])",
                "  assert_near(moved, 0.75)",
                "end")
            .only());
  }

  @Test
  void callsOfSeveralThreadsAreAnsweredBesideEachOther() {
    passes(
        Suite.of(
                "def slow(n):",
                "  sleep(n * 0.1)",
                "  return True",
                "end",
                "thread reader():",
                "  get_standard_digital_in(5)",
                "end",
                "def test_threads():",
                "  mock_by(\"get_standard_digital_in\", \"slow\")",
                "  long = run reader()",
                "  get_standard_digital_in(1)",
                "  assert_near(robot_time(), 0.1, 0.02)",
                "  join long",
                "  assert_near(robot_time(), 0.5, 0.02)",
                "end")
            .only());
  }

  @Test
  void whatGoesWrongInTheFunctionIsToldAtItsLine() {
    TestResult result =
        Suite.of(
                "def level(n):",
                "  return 1 / n",
                "end",
                "def test_a():",
                "  mock_by(\"get_standard_digital_in\", \"level\")",
                "  get_standard_digital_in(0)",
                "end")
            .only();

    assertEquals(TestStatus.ERROR, result.status());
    assertEquals(2, result.failure().orElseThrow().place().orElseThrow().line());
    assertEquals(List.of(), result.failure().orElseThrow().stack());
  }

  @Test
  void aFunctionThatCannotTakeTheArgumentsIsToldAtItsPlace() {
    assertEquals(
        List.of(
            "cell/pick_test.script:5:38: error: level takes 2 to 3 arguments;"
                + " get_standard_digital_in has 1",
            "cell/pick_test.script:6:18: error: none takes 0 arguments; two has 1 to 2"),
        Suite.of(
                "def two(a, b=1):",
                "  return a",
                "end",
                "def test_a():",
                "  mock_by(\"get_standard_digital_in\", \"level\")",
                "  mock_by(\"two\", \"none\")",
                "end",
                "def level(a, b, c=3):",
                "  return a + b + c",
                "end",
                "def none():",
                "end")
            .problems());
  }

  @Test
  void oneThatCannotTakeTheArgumentsOfAProgramsFunctionIsToldWhereItIsNamed() {
    TestResult result =
        Suite.of(
                "def hold():",
                "  return 1",
                "end",
                "def test_a():",
                "  mock_by(\"grip\", \"hold\")",
                "  start(\"pick.script\")",
                "  wait_for_end()",
                "end")
            .with("cell/pick.script", PICK)
            .only();

    assertEquals(
        "hold takes 0 arguments; grip was called with 2", result.failure().orElseThrow().message());
    assertEquals(
        "cell/pick_test.script:5:3", result.failure().orElseThrow().place().orElseThrow().text());
  }

  @Test
  void bothNamesStandInQuotesAndTheFunctionMustBeThere() {
    assertEquals(
        List.of(
            "cell/pick_test.script:2:3: error: mock_by needs the names of two functions in quotes"),
        Suite.of("def test_a():", "  mock_by(\"grip\", test_a)", "end").problems());
    assertEquals(
        List.of(
            "cell/pick_test.script:2:19: error: there is no function hold in this file that could"
                + " answer"),
        Suite.of("def test_a():", "  mock_by(\"grip\", \"hold\")", "end").problems());
  }

  @Test
  void aFunctionThatAnswersMayNotStartToMoveWhereTheTestOnlyWatches() {
    List<String> problems =
        Suite.of(
                "def hold(n):",
                "  movej([0, 0, 0, 0, 0, 0])",
                "end",
                "def test_a():",
                "  mock_by(\"grip\", \"hold\")",
                "  start(\"pick.script\")",
                "end")
            .problems();

    assertEquals(1, problems.size());
  }

  @Test
  void whatIsRunAheadOfTheArmTakesNoAnswerAway() {
    passes(
        Suite.of(
                "def test_blends():",
                "  mock(\"get_standard_digital_in\", [True, False])",
                "  movej([0.1, -1.5, 0, -1.5, 0, 0], a=2, v=1, r=0.02)",
                "  assert_true(get_standard_digital_in(0))",
                "  movej([0.2, -1.5, 0, -1.5, 0, 0], a=2, v=1)",
                "  assert_equal(mock_calls(\"get_standard_digital_in\"), 1)",
                "end")
            .only());
  }

  @Test
  void aFunctionAnswersRemoteProcedures() {
    passes(
        Suite.of(
                "def part(kind):",
                "  if kind == \"bracket\":",
                "    return p[0.3, 0.1, 0, 0, 0, 0]",
                "  end",
                "  return p[0, 0, 0, 0, 0, 0]",
                "end",
                "def test_camera():",
                "  rpc_answer_by(\"get_part\", \"part\")",
                "  cam = rpc_factory(\"xmlrpc\", \"http://127.0.0.1:4040/RPC2\")",
                "  assert_pose_near(cam.get_part(\"bracket\"), p[0.3, 0.1, 0, 0, 0, 0])",
                "  assert_equal(rpc_calls(\"get_part\"), 1)",
                "end")
            .only());
  }
}
