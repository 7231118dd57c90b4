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
  private final ReportLanguage language;

  ConsoleSummary(ConsoleStyle style, SourceExcerpts excerpts, ReportLanguage language) {
    this.style = style;
    this.excerpts = excerpts;
    this.language = language;
  }

  /** A red test with everything that is known of it. */
  List<String> red(TestResult result) {
    List<String> lines = new ArrayList<>();
    lines.add(
        style.mark(result.status())
            + language.text(
                ended(result.status()),
                style.red(name(result.id())),
                ReportText.duration(result.robotTimeS())));
    lines.addAll(FailureText.lines(result, excerpts, language));
    ReportText.Output output = ReportText.output(result, OUTPUT_LINES, OUTPUT_CHARACTERS);
    if (!output.lines().isEmpty()) {
      lines.add("  " + title(output));
      output.lines().forEach(each -> lines.add(style.faint("    | " + language.output(each))));
    }
    return lines;
  }

  private static String ended(TestStatus status) {
    return switch (status) {
      case PASSED -> "passedAfter";
      case FAILED -> "failedAfter";
      case ERROR -> "errorAfter";
      case TIMED_OUT -> "timedOutAfter";
      case SKIPPED -> "skippedAfter";
    };
  }

  private String title(ReportText.Output output) {
    int last = output.lines().size();
    return output.left() == 0
        ? language.text("output")
        : language.text("lastOfOutput", last, output.left() + last);
  }

  /** A file of which no test could run, and what is wrong with it. */
  List<String> broken(BrokenTestFile file) {
    List<String> lines = new ArrayList<>();
    lines.add(
        style.mark(TestStatus.ERROR)
            + language.text("noTestCouldRun", style.red(ReportText.line(file.file()))));
    lines.addAll(
        file.problems().isEmpty()
            ? List.of(language.text("errorNoTestCouldRun", ReportText.line(file.file())))
            : language.shown(ReportText.problems(file)));
    return lines;
  }

  /** How many tests had which end. */
  String lastLine(SuiteResult result) {
    if (result.results().isEmpty() && result.broken().isEmpty() && result.notRun() == 0) {
      return language.text("noTests", result.seed());
    }
    String counts = counts(result, language);
    return language.text(
        "countsInRobotTime",
        result.red() ? style.red(counts) : style.green(counts),
        ReportText.duration(robotTimeS(result)),
        result.seed());
  }

  /** {@code 3.2 s of robot time}: of all tests together. */
  static String robotTime(SuiteResult result) {
    return ReportText.duration(robotTimeS(result)) + " of robot time";
  }

  private static double robotTimeS(SuiteResult result) {
    return result.results().stream().mapToDouble(TestResult::robotTimeS).sum();
  }

  /** The same as for some tests, with files that are broken and tests that were left out. */
  static String counts(SuiteResult result, ReportLanguage language) {
    String counts = counts(result.results(), language);
    int broken = result.broken().size();
    if (broken > 0) {
      counts = language.listed(counts, language.count(broken, "oneBrokenFile", "brokenFiles"));
    }
    return result.notRun() > 0
        ? language.listed(counts, language.text("notRun", result.notRun()))
        : counts;
  }

  /** {@code 12 passed, 1 failed, 1 skipped}: only what there is, and always the passed ones. */
  static String counts(List<TestResult> results, ReportLanguage language) {
    Map<TestStatus, Integer> counts = new EnumMap<>(TestStatus.class);
    results.forEach(each -> counts.merge(each.status(), 1, Integer::sum));
    String text = "";
    for (TestStatus each : TestStatus.values()) {
      int count = counts.getOrDefault(each, 0);
      if (each == TestStatus.PASSED || count > 0) {
        text = language.listed(text, language.count(count, each));
      }
    }
    return text;
  }

  /** A test among those of all files. */
  static String name(TestId id) {
    return ReportText.line(id.file()) + " " + ReportText.line(id.name());
  }
}
