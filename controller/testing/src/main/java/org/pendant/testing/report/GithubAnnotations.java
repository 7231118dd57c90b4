package org.pendant.testing.report;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.testing.BrokenTestFile;
import org.pendant.testing.FileWarnings;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestPlace;
import org.pendant.testing.TestResult;

/**
 * GitHub annotations: lines by which GitHub Actions marks red tests at their lines in a commit,
 * when a step writes them to its output.
 */
public final class GithubAnnotations {
  /** GitHub shows 10 for each step and 50 for each job; the rest is only in the log. */
  private static final int MAX_ANNOTATIONS = 50;

  /** Longest text of an annotation, in characters. */
  private static final int MAX_TEXT = 4_000;

  private static final Pattern PROBLEM =
      Pattern.compile(":(\\d{1,9}):(\\d{1,9}): (?:error: |warning: )?(.*)", Pattern.DOTALL);

  private GithubAnnotations() {}

  /** The lines, without line ends; none where nothing is red. */
  public static List<String> lines(SuiteResult result) {
    List<String> lines = new ArrayList<>();
    List<TestResult> red = result.results().stream().filter(each -> each.status().red()).toList();
    for (BrokenTestFile each : result.broken()) {
      if (lines.size() < MAX_ANNOTATIONS) {
        lines.add(annotation(each));
      }
    }
    for (TestResult each : red) {
      if (lines.size() < MAX_ANNOTATIONS) {
        lines.add(annotation(each));
      }
    }
    int shown = lines.size();
    for (FileWarnings each : result.warnings()) {
      for (String warning : each.lines()) {
        if (lines.size() < MAX_ANNOTATIONS) {
          lines.add(warning(each.file(), warning));
        }
      }
    }
    int left = result.broken().size() + red.size() - shown;
    if (left > 0) {
      lines.add("::error title=pendant test::" + left + " more, see the log");
    }
    return lines;
  }

  private static String annotation(TestResult test) {
    TestPlace place = test.failure().flatMap(TestFailure::place).orElse(test.place());
    List<String> text = new ArrayList<>(ReportText.message(test));
    text.addAll(FailureText.calls(test, ReportLanguage.ENGLISH));
    return annotation(
        place,
        ReportText.line(test.id().name()) + ": " + ReportText.status(test.status()),
        String.join("\n", text));
  }

  private static String warning(String file, String warning) {
    String visible = ReportText.line(warning);
    String name = ReportText.line(file);
    Matcher matcher =
        PROBLEM.matcher(visible.startsWith(name) ? visible.substring(name.length()) : "");
    boolean placed = matcher.matches();
    TestPlace place =
        placed
            ? new TestPlace(
                file, Integer.parseInt(matcher.group(1)), Integer.parseInt(matcher.group(2)), "")
            : new TestPlace(file, 1, 0, "");
    return annotation("warning", place, "warning", placed ? matcher.group(3) : visible);
  }

  /** The first problem has the place; the others are in the text. */
  private static String annotation(BrokenTestFile broken) {
    List<String> problems = ReportText.problems(broken);
    String first = problems.getFirst();
    String file = ReportText.line(broken.file());
    Matcher matcher = PROBLEM.matcher(first.startsWith(file) ? first.substring(file.length()) : "");
    boolean placed = matcher.matches();
    int line = placed ? Integer.parseInt(matcher.group(1)) : 1;
    int column = placed ? Integer.parseInt(matcher.group(2)) : 0;
    List<String> text = new ArrayList<>(problems);
    if (placed) {
      text.set(0, matcher.group(3));
    }
    return annotation(
        new TestPlace(broken.file(), line, column, ""),
        "no test of the file could run",
        String.join("\n", text));
  }

  private static String annotation(TestPlace place, String title, String text) {
    return annotation("error", place, title, text);
  }

  private static String annotation(String level, TestPlace place, String title, String text) {
    String column = place.column() > 0 ? ",col=" + place.column() : "";
    String bounded = text.length() <= MAX_TEXT ? text : text.substring(0, MAX_TEXT) + "...";
    return "::"
        + level
        + " file="
        + property(ReportText.line(place.file()))
        + ",line="
        + place.line()
        + column
        + ",title="
        + property(title)
        + "::"
        + data(bounded);
  }

  private static String data(String text) {
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A");
  }

  private static String property(String text) {
    return data(text).replace(":", "%3A").replace(",", "%2C");
  }
}
