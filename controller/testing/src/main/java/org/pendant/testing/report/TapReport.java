package org.pendant.testing.report;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.pendant.testing.BrokenTestFile;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestPlace;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;

/**
 * TAP report: results by the Test Anything Protocol, version 14, with a block of YAML below each
 * red test. Times are robot time, so that the same results are the same bytes.
 */
public final class TapReport {
  private static final int OUTPUT_LINES = 50;
  private static final int OUTPUT_CHARACTERS = 8_000;

  private final Writer out;
  private int number;

  private TapReport(Writer out) {
    this.out = out;
  }

  /**
   * Writes the text of the file, as UTF-8.
   *
   * @param out is left open
   */
  public static void write(SuiteResult result, OutputStream out) throws IOException {
    Writer writer = new BufferedWriter(new OutputStreamWriter(out, StandardCharsets.UTF_8));
    new TapReport(writer).all(result);
    writer.flush();
  }

  private void all(SuiteResult result) throws IOException {
    line("TAP version 14");
    line("1.." + (result.results().size() + result.broken().size()));
    line("# seed " + result.seed());
    for (TestResult each : result.results()) {
      test(each);
    }
    for (BrokenTestFile each : result.broken()) {
      broken(each);
    }
    if (result.notRun() > 0) {
      line("# not run: " + ReportText.count(result.notRun(), "test"));
    }
  }

  private void test(TestResult test) throws IOException {
    boolean skipped = test.status() == TestStatus.SKIPPED;
    String reason = test.skipped().isEmpty() ? "" : " " + ReportText.line(test.skipped());
    point(
        !test.status().red(),
        ConsoleSummary.name(test.id()),
        skipped ? " # SKIP" + escaped(reason) : "");
    if (!test.status().red()) {
      return;
    }
    line("  ---");
    entry("message", String.join("\n", ReportText.message(test)));
    entry("severity", test.status() == TestStatus.FAILED ? "fail" : "error");
    if (test.failure().isPresent()) {
      entry("code", ReportText.line(test.failure().get().code()));
    }
    line("  duration_ms: " + Math.round(test.robotTimeS() * 1e3));
    Optional<TestPlace> failed = test.failure().flatMap(TestFailure::place);
    place(failed.orElse(test.place()));
    stack(FailureText.calls(test, ReportLanguage.ENGLISH));
    // As one text: harnesses that read only simple YAML stumble over lists of any text.
    List<String> output = ReportText.output(test, OUTPUT_LINES, OUTPUT_CHARACTERS).lines();
    if (!output.isEmpty()) {
      entry("output", String.join("\n", output));
    }
    line("  ...");
  }

  private void place(TestPlace place) throws IOException {
    entry("file", ReportText.line(place.file()));
    line("  line: " + place.line());
    if (place.column() > 0) {
      line("  column: " + place.column());
    }
  }

  private void broken(BrokenTestFile broken) throws IOException {
    point(false, ReportText.line(broken.file()) + " (the file itself)", "");
    line("  ---");
    entry("message", String.join("\n", ReportText.problems(broken)));
    entry("severity", "error");
    entry("code", "broken-file");
    line("  ...");
  }

  private void point(boolean ok, String description, String directive) throws IOException {
    number++;
    line((ok ? "ok " : "not ok ") + number + " - " + escaped(description) + directive);
  }

  private void entry(String key, String value) throws IOException {
    line("  " + key + ": " + quoted(value));
  }

  private void stack(List<String> calls) throws IOException {
    if (!calls.isEmpty()) {
      line("  stack:");
      for (String each : calls) {
        line("    - " + quoted(each));
      }
    }
  }

  private void line(String text) throws IOException {
    out.write(text);
    out.write('\n');
  }

  /** A number sign would begin a directive. */
  private static String escaped(String text) {
    return text.replace("\\", "\\\\").replace("#", "\\#");
  }

  /** A text of YAML in double quotes, in which only these are special: the rest is visible. */
  private static String quoted(String text) {
    StringBuilder quoted = new StringBuilder(text.length() + 2).append('"');
    for (int i = 0; i < text.length(); i++) {
      char each = text.charAt(i);
      switch (each) {
        case '"', '\\' -> quoted.append('\\').append(each);
        case '\n' -> quoted.append("\\n");
        case '\t' -> quoted.append("\\t");
        case '\uFEFF' -> quoted.append(String.format(Locale.ROOT, "\\u%04x", (int) each));
        default -> quoted.append(each);
      }
    }
    return quoted.append('"').toString();
  }
}
