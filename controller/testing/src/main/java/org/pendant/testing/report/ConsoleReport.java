package org.pendant.testing.report;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import org.pendant.language.source.Source;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestId;
import org.pendant.testing.TestPlace;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;
import org.pendant.testing.report.ConsoleStyle.Detail;
import org.pendant.testing.report.ConsoleStyle.Feature;
import org.pendant.text.TerminalColumns;

/**
 * Console report: tests as they end, and a summary, for people.
 *
 * <p>Tests end in an order that is not the same twice. So a line is written when everything above
 * it is known, in the order of files and tests, and the same results are the same bytes; on a
 * {@linkplain Feature#TERMINAL terminal}, where nobody compares bytes, each line at once. May be
 * called from any thread.
 */
public final class ConsoleReport {
  /** Longest message in the line of a test, in characters. */
  private static final int MAX_MESSAGE = 200;

  /** How often the progress is written in all, so that it costs nothing beside many tests. */
  private static final int PROGRESS_STEPS = 500;

  private final ConsoleStyle style;
  private final ReportLanguage language;
  private final ConsoleSummary summary;
  private final Consumer<String> out;
  private final Map<String, TestedFile> files = new LinkedHashMap<>();
  private final Map<TestId, Integer> order = new HashMap<>();
  private final Deque<TestedFile> waiting = new ArrayDeque<>();
  private int finished;
  private int red;
  private String progress = "";
  private boolean written;

  /** What is known so far of one file. */
  private static final class TestedFile {
    private final String name;
    private final List<TestResult> results = new ArrayList<>();
    private int planned;
    private boolean written;

    TestedFile(String name) {
      this.name = name;
    }

    boolean complete() {
      return planned > 0 && results.size() >= planned;
    }
  }

  /** A report of one run, in English. */
  public ConsoleReport(
      ConsoleStyle style, Function<String, Optional<Source>> sources, Consumer<String> out) {
    this(style, sources, out, ReportLanguage.ENGLISH);
  }

  /**
   * A report of one run.
   *
   * @param sources the text of a file by its name in places, if it can be had
   * @param out takes pieces of text with their line ends; they hold no control characters but those
   *     that the style asks for, whatever tests say
   */
  public ConsoleReport(
      ConsoleStyle style,
      Function<String, Optional<Source>> sources,
      Consumer<String> out,
      ReportLanguage language) {
    this.style = style;
    this.language = language;
    this.summary = new ConsoleSummary(style, new SourceExcerpts(sources), language);
    this.out = out;
  }

  /** Which tests are going to run, in the order of the report. */
  public synchronized void begin(List<TestId> plan) {
    for (TestId each : plan) {
      order.putIfAbsent(each, order.size());
      file(each.file()).planned++;
    }
    waiting.addAll(files.values());
    showProgress();
  }

  /** What came of one of them. */
  public synchronized void finished(TestResult result) {
    TestedFile file = file(result.id().file());
    file.results.add(result);
    finished++;
    boolean isRed = result.status().red();
    red += isRed ? 1 : 0;
    boolean every = style.detail() == Detail.VERBOSE;
    if (!style.has(Feature.TERMINAL)) {
      while (!waiting.isEmpty() && waiting.getFirst().complete()) {
        write(waiting.removeFirst());
      }
      return;
    }
    if (every || (isRed && style.detail() != Detail.QUIET)) {
      String name = ReportText.line(result.id().file()) + " ";
      line(testLine(name, result));
    }
    if (file.complete()) {
      write(file);
    }
    int steps = Math.max(1, order.size() / PROGRESS_STEPS);
    if (isRed || progress.isEmpty() || finished % steps == 0) {
      showProgress();
    }
  }

  /** The end: what has not been told yet, all red tests in detail, and how many there were. */
  public synchronized void end(SuiteResult result) {
    hideProgress();
    Map<String, List<TestResult>> all = new LinkedHashMap<>();
    files.keySet().forEach(each -> all.put(each, new ArrayList<>()));
    result
        .results()
        .forEach(each -> all.computeIfAbsent(each.id().file(), f -> new ArrayList<>()).add(each));
    all.forEach(
        (name, results) -> {
          TestedFile file = file(name);
          if (!file.written && !results.isEmpty()) {
            file.results.clear();
            file.results.addAll(results);
            write(file);
          }
        });
    result.results().stream()
        .filter(each -> each.status().red())
        .forEach(each -> block(summary.red(each)));
    result.broken().forEach(each -> block(summary.broken(each)));
    if (!result.warnings().isEmpty() && style.detail() != Detail.QUIET) {
      block(
          result.warnings().stream()
              .flatMap(each -> ReportText.warnings(each.lines()))
              .map(language::shown)
              .toList());
    }
    block(List.of(summary.lastLine(result)));
    if (style.has(Feature.WALL_TIME)) {
      line(language.text("byWallClock", ReportText.duration(result.wallTimeS())));
    }
  }

  private TestedFile file(String name) {
    return files.computeIfAbsent(name, TestedFile::new);
  }

  private void write(TestedFile file) {
    file.written = true;
    if (style.detail() == Detail.QUIET) {
      return;
    }
    List<TestResult> results = file.results;
    results.sort(Comparator.comparingInt(each -> order.getOrDefault(each.id(), order.size())));
    TestStatus status =
        results.stream().anyMatch(each -> each.status().red())
            ? TestStatus.FAILED
            : results.stream().allMatch(each -> each.status() == TestStatus.SKIPPED)
                ? TestStatus.SKIPPED
                : TestStatus.PASSED;
    double robotTimeS = results.stream().mapToDouble(TestResult::robotTimeS).sum();
    line(
        style.mark(status)
            + language.text(
                "countsOfFile",
                ReportText.line(file.name),
                ConsoleSummary.counts(results, language),
                ReportText.duration(robotTimeS)));
    if (!style.has(Feature.TERMINAL)) {
      results.stream()
          .filter(each -> style.detail() == Detail.VERBOSE || each.status().red())
          .forEach(each -> line("  " + testLine("", each)));
    }
  }

  private String testLine(String file, TestResult result) {
    String name = file + ReportText.line(result.id().name());
    String line =
        switch (result.status()) {
          case PASSED ->
              language.text("testPassed", name, ReportText.duration(result.robotTimeS()));
          case SKIPPED ->
              result.skipped().isEmpty()
                  ? name
                  : language.text(
                      "testBecause",
                      name,
                      language.shown(ReportText.line(result.skipped(), MAX_MESSAGE)));
          case FAILED, ERROR, TIMED_OUT ->
              language.text("testBecause", name, message(result)) + place(result);
        };
    return style.mark(result.status()) + line;
  }

  private String message(TestResult result) {
    String first = language.shown(ReportText.message(result)).getFirst();
    return first.length() <= MAX_MESSAGE ? first : first.substring(0, MAX_MESSAGE) + "...";
  }

  private String place(TestResult result) {
    Optional<TestPlace> place = result.failure().flatMap(TestFailure::place);
    return place.map(each -> style.faint(" (" + FailureText.text(each) + ")")).orElse("");
  }

  private void block(List<String> lines) {
    if (written) {
      line("");
    }
    lines.forEach(this::line);
  }

  private void line(String text) {
    hideProgress();
    written = true;
    out.accept(text + "\n");
  }

  private void showProgress() {
    if (style.has(Feature.TERMINAL) && !order.isEmpty()) {
      hideProgress();
      progress =
          red == 0
              ? language.text("progress", finished, order.size())
              : language.text("progressWithRed", finished, order.size(), red);
      out.accept(progress);
    }
  }

  /** Written over with blanks, which every terminal understands. */
  private void hideProgress() {
    if (!progress.isEmpty()) {
      out.accept("\r" + " ".repeat(TerminalColumns.of(progress)) + "\r");
      progress = "";
    }
  }
}
