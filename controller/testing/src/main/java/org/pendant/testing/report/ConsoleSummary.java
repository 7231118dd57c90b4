package org.pendant.testing.report;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.pendant.testing.BrokenTestFile;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestId;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;

/** Console summary: what stands at the end of a console report. */
final class ConsoleSummary {
  private static final int OUTPUT_LINES = 10;
  private static final int OUTPUT_CHARACTERS = 4_000;

  private final ConsoleStyle style;
  private final SourceExcerpts excerpts;

  ConsoleSummary(ConsoleStyle style, SourceExcerpts excerpts) {
    this.style = style;
    this.excerpts = excerpts;
  }

  /** A red test with everything that is known of it. */
  List<String> red(TestResult result) {
    List<String> lines = new ArrayList<>();
    lines.add(
        style.mark(result.status())
            + style.red(name(result.id()))
            + (result.status() == TestStatus.ERROR
                ? ": ended by an error"
                : ": " + ReportText.status(result.status()))
            + " after "
            + ReportText.duration(result.robotTimeS())
            + " of robot time");
    lines.addAll(FailureText.lines(result, excerpts));
    ReportText.Output output = ReportText.output(result, OUTPUT_LINES, OUTPUT_CHARACTERS);
    if (!output.lines().isEmpty()) {
      lines.add("  " + output.title() + ":");
      output.lines().forEach(each -> lines.add(style.faint("    | " + each)));
    }
    return lines;
  }

  /** A file of which no test could run, and what is wrong with it. */
  List<String> broken(BrokenTestFile file) {
    List<String> lines = new ArrayList<>();
    lines.add(
        style.mark(TestStatus.ERROR)
            + style.red(ReportText.line(file.file()))
            + ": no test of it could run");
    lines.addAll(ReportText.problems(file));
    return lines;
  }

  /** How many tests had which end. */
  String lastLine(SuiteResult result) {
    if (result.results().isEmpty() && result.broken().isEmpty() && result.notRun() == 0) {
      return "no tests (seed " + result.seed() + ")";
    }
    String counts = counts(result);
    return (result.red() ? style.red(counts) : style.green(counts))
        + " in "
        + robotTime(result)
        + " (seed "
        + result.seed()
        + ")";
  }

  /** {@code 3.2 s of robot time}: of all tests together. */
  static String robotTime(SuiteResult result) {
    double robotTimeS = result.results().stream().mapToDouble(TestResult::robotTimeS).sum();
    return ReportText.duration(robotTimeS) + " of robot time";
  }

  /** The same as for some tests, with files that are broken and tests that were left out. */
  static String counts(SuiteResult result) {
    String counts = counts(result.results());
    if (!result.broken().isEmpty()) {
      counts += ", " + ReportText.count(result.broken().size(), "broken file");
    }
    return result.notRun() > 0 ? counts + ", " + result.notRun() + " not run" : counts;
  }

  /** {@code 12 passed, 1 failed, 1 skipped}: only what there is, and always the passed ones. */
  static String counts(List<TestResult> results) {
    Map<TestStatus, Integer> counts = new EnumMap<>(TestStatus.class);
    results.forEach(each -> counts.merge(each.status(), 1, Integer::sum));
    StringBuilder text = new StringBuilder();
    for (TestStatus each : TestStatus.values()) {
      int count = counts.getOrDefault(each, 0);
      if (each == TestStatus.PASSED || count > 0) {
        text.append(text.isEmpty() ? "" : ", ");
        text.append(
            each == TestStatus.ERROR
                ? ReportText.count(count, "error")
                : count + " " + ReportText.status(each));
      }
    }
    return text.toString();
  }

  /** A test among those of all files. */
  static String name(TestId id) {
    return ReportText.line(id.file()) + " " + ReportText.line(id.name());
  }
}
