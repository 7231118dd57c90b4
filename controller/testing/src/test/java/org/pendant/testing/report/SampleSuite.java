package org.pendant.testing.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import org.pendant.language.source.Source;
import org.pendant.testing.BrokenTestFile;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestId;
import org.pendant.testing.TestPlace;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;

/** Results for tests of reports: a suite with one of each kind, and parts for others. */
final class SampleSuite {
  static final String PICK = "cell/pick_test.script";
  static final String GRIP = "cell/grip_test.script";

  private static final String GRIP_TEXT =
      """
      def close(width):
        assert_near(width, 0.04, 0.001)
      end

      def test_grip(width, closed):
        close(width)
      end

      def test_force():
        force_mode(p[0,0,0,0,0,0])
      end
      """;

  private SampleSuite() {}

  /** Twelve tests in two files and a file that is broken. */
  static SuiteResult suite() {
    return new SuiteResult(
        List.of(
            passed(PICK, "test_pick", 1.25),
            passed(PICK, "test_place", 1.2),
            skipped(PICK, "test_two_arms", "there is one arm; see #7"),
            passed(GRIP, "test_open", 0.046),
            failed(),
            error(),
            timedOut()),
        List.of(
            new BrokenTestFile(
                "cell/old_test.script",
                List.of(
                    "cell/old_test.script:3:5: error: `movee` is not known\n  movee(q)\n  ^~~~~"))),
        4711,
        2,
        1.5);
  }

  static TestResult failed() {
    return new TestResult(
        new TestId(GRIP, "test_grip", "[0.05, True]"),
        new TestPlace(GRIP, 5, 1, "test_grip"),
        new TreeSet<>(List.of("gripper", "slow")),
        TestStatus.FAILED,
        "",
        Optional.of(
            new TestFailure(
                "assertion-failed",
                "width is 0.05 m, expected 0.04 m\nwithin 0.001 m",
                Optional.of(new TestPlace(GRIP, 2, 3, "close")),
                List.of(new TestPlace(GRIP, 6, 3, "test_grip")))),
        0.1,
        0.002,
        List.of("closing", "width 0.05"));
  }

  static TestResult error() {
    return red(
        "test_force",
        TestStatus.ERROR,
        new TestFailure(
            "missing-argument",
            "force_mode: 4 arguments are missing",
            Optional.of(new TestPlace(GRIP, 10, 3, "test_force")),
            List.of()));
  }

  static TestResult timedOut() {
    return red(
        "test_forever",
        TestStatus.TIMED_OUT,
        new TestFailure(
            "timed-out", "ran longer than 60 s of robot time", Optional.empty(), List.of()));
  }

  static TestResult passed(String file, String function, double robotTimeS) {
    return result(file, function, TestStatus.PASSED, "", Optional.empty(), robotTimeS, List.of());
  }

  static TestResult skipped(String file, String function, String reason) {
    return result(file, function, TestStatus.SKIPPED, reason, Optional.empty(), 0, List.of());
  }

  static TestResult red(String function, TestStatus status, TestFailure failure) {
    return result(GRIP, function, status, "", Optional.of(failure), 0.5, List.of());
  }

  /** A test in {@link #GRIP} that failed with a message and had that output. */
  static TestResult failed(String message, List<String> output) {
    return result(
        GRIP,
        "test_x",
        TestStatus.FAILED,
        "",
        Optional.of(new TestFailure("assertion-failed", message, Optional.empty(), List.of())),
        0.5,
        output);
  }

  static SuiteResult of(TestResult... results) {
    return new SuiteResult(List.of(results), List.of(), 1, 0, 0.5);
  }

  /** Many tests, a hundred in each file, every tenth of them red. */
  static SuiteResult many(int count) {
    List<TestResult> results = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      String file = "many/f" + i / 100 + "_test.script";
      TestStatus status = i % 10 == 3 ? TestStatus.FAILED : TestStatus.PASSED;
      TestFailure failure =
          new TestFailure(
              "assertion-failed",
              "3 is not " + i,
              Optional.of(new TestPlace(GRIP, 2, 3, "")),
              List.of());
      results.add(
          result(
              file,
              "test_" + i,
              status,
              "",
              status.red() ? Optional.of(failure) : Optional.empty(),
              0.002,
              List.of("a line")));
    }
    return new SuiteResult(results, List.of(), 1, 0, 0.5);
  }

  /** The text of {@link #GRIP}; of other files there is none. */
  static Optional<Source> source(String file) {
    return file.equals(GRIP) ? Optional.of(Source.of(file, GRIP_TEXT)) : Optional.empty();
  }

  private static TestResult result(
      String file,
      String function,
      TestStatus status,
      String skipped,
      Optional<TestFailure> failure,
      double robotTimeS,
      List<String> output) {
    return new TestResult(
        new TestId(file, function, ""),
        new TestPlace(file, 9, 1, function),
        new TreeSet<>(),
        status,
        skipped,
        failure,
        robotTimeS,
        0.001,
        output);
  }
}
