package org.pendant.testing.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;
import org.pendant.testing.coverage.CoverageReport;
import org.pendant.testing.coverage.Share;

class SuiteTest {
  private static Suite ofMany(int count) {
    List<String> lines = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      lines.add("def test_" + i + "():");
      lines.add("  sleep(random() / 10)");
      lines.add("  assert_true(" + (i % 7 == 3 ? "False" : "True") + ")");
      lines.add("end");
    }
    return Suite.of(lines.toArray(String[]::new));
  }

  private static TestSettings changed(TestSettings from, int jobs, boolean failFast) {
    return new TestSettings(
        from.controller(), from.seed(), jobs, from.timeoutS(), from.wallTimeout(), failFast);
  }

  /** What must repeat of a result. */
  private static List<String> told(SuiteResult result) {
    return result.results().stream()
        .map(each -> each.id() + " " + each.status() + " " + each.failure() + each.robotTimeS())
        .toList();
  }

  @Test
  void resultsAreTheSameHoweverManyRunAtOnce() {
    Suite suite = ofMany(40);

    SuiteResult one = suite.run();
    SuiteResult four = suite.with(changed(suite.settings(), 4, false)).run();

    assertEquals(told(one), told(four));
    assertEquals(6, one.count(TestStatus.FAILED));
  }

  @Test
  void nothingMoreRunsAfterTheFirstRedTestWhereThatIsWanted() {
    Suite suite = ofMany(40);

    SuiteResult result = suite.with(changed(suite.settings(), 4, true)).run();

    assertEquals(1, result.count(TestStatus.FAILED));
    assertEquals(40, result.results().size() + result.notRun());
    assertTrue(result.notRun() > 0);
  }

  @Test
  void partsOfAPlanAreTogetherAllOfIt() {
    Suite suite = ofMany(10);
    List<String> all = new ArrayList<>();

    for (int part = 1; part <= 3; part++) {
      all.addAll(suite.plan().shard(part, 3).tests().stream().map(t -> t.id().name()).toList());
    }

    assertEquals(
        suite.plan().tests().stream().map(t -> t.id().name()).sorted().toList(),
        all.stream().sorted().toList());
  }

  @Test
  void eachTestHasAControllerOfItsOwn() {
    SuiteResult result =
        Suite.of(
                "count = 0",
                "def test_one():",
                "  count = count + 1",
                "  set_standard_digital_out(0, True)",
                "  assert_equal(count, 1)",
                "end",
                "def test_two():",
                "  count = count + 1",
                "  assert_false(get_standard_digital_out(0))",
                "  assert_equal(count, 1)",
                "end")
            .run();

    assertEquals(2, result.count(TestStatus.PASSED));
  }

  @Test
  void functionsBeforeAndAfterEachTestRunAroundIt() {
    TestResult result =
        Suite.of(
                "def before_each():",
                "  set_standard_digital_in(0, True)",
                "end",
                "def after_each():",
                "  assert_false(get_standard_digital_out(0), \"left on\")",
                "end",
                "def test_lamp():",
                "  set_standard_digital_out(0, get_standard_digital_in(0))",
                "end")
            .only();

    assertEquals("left on: condition is True, must be False", result.failure().get().message());
  }

  @Test
  void aMillionAssertionsAreNoTrouble() {
    TestResult result =
        Suite.of(
                "# @timeout 3000",
                "def test_many():",
                "  i = 0",
                "  while i < 1000000:",
                "    assert_true(i >= 0)",
                "    i = i + 1",
                "  end",
                "end")
            .only();

    assertEquals(TestStatus.PASSED, result.status());
  }

  @Test
  void aTestThatTakesTooLongOnTheComputerIsTimedOut() {
    Suite suite = Suite.of("def test_busy():", "  while True:", "    sync()", "  end", "end");
    TestSettings from = suite.settings();
    suite.with(new TestSettings(from.controller(), 1, 1, 1e9, Duration.ofMillis(50), false));

    assertEquals(TestStatus.TIMED_OUT, suite.only().status());
  }

  @Test
  void aTestThatTakesAllMemoryIsRedAndTheOthersStillCount() {
    SuiteResult result =
        Suite.of(
                "def test_greedy():",
                "  a = make_list(100000, 0.5, 1000000)",
                "  b = struct(x=a, y=a)",
                "  while True:",
                "    b = struct(x=b, y=b)",
                "  end",
                "end",
                "def test_modest():",
                "  assert_true(True)",
                "end")
            .run();

    assertEquals(TestStatus.ERROR, result.results().getFirst().status());
    assertEquals(TestStatus.PASSED, result.results().getLast().status());
  }

  @Test
  void aTestMayWantToEndWithAnError() {
    SuiteResult result =
        Suite.of(
                "def test_refuses():",
                "  expect_failure(\"must not be negative\")",
                "  x = sqrt(-1)",
                "end",
                "def test_accepts():",
                "  expect_failure(\"must not be negative\")",
                "  x = sqrt(1)",
                "end")
            .run();

    assertEquals(TestStatus.PASSED, result.results().getFirst().status());
    assertEquals(TestStatus.FAILED, result.results().getLast().status());
  }

  @Test
  void coverageCountsAFileOnceWhetherItIsImportedOrStarted() {
    CoverageReport report =
        Suite.of(
                "import_script(\"../lib/pick.script\")",
                "def test_height():",
                "  assert_near(height_of(3), 0.15)",
                "end",
                "def test_runs():",
                "  start(\"../lib/pick.script\")",
                "  wait_for_end()",
                "end")
            .with(
                "lib/pick.script",
                "def pick():",
                "  part = 0.05",
                "  def height_of(n):",
                "    return n * part",
                "  end",
                "  def unused():",
                "    return 1",
                "  end",
                "  if get_standard_digital_in(0):",
                "    sync()",
                "  end",
                "  sleep(0.1)",
                "end")
            .coverage();

    assertEquals(List.of("lib/pick.script"), report.files().stream().map(f -> f.file()).toList());
    assertEquals("7, 10", report.files().getFirst().missing());
    assertEquals("2/3", shown(report.calledFunctions()));
    assertEquals("1/2", shown(report.branchWays()));
  }

  @Test
  void whoStopsASuiteDoesNotWaitForTheTestsThatRun() {
    SuiteResult result =
        Suite.of(
                "# @golden",
                "def test_endless():",
                "  while True:",
                "    sync()",
                "  end",
                "end",
                "# @golden",
                "def test_other():",
                "end")
            .stopped();

    assertEquals(List.of(), result.results());
    assertEquals(2, result.notRun());
  }

  private static String shown(Share share) {
    return share.reached() + "/" + share.total();
  }
}
