package org.pendant.testing.report;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.VisibleText;
import org.pendant.testing.BrokenTestFile;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;

/**
 * Report text: what tests, programs and files say, as every report may hold it: bytes decoded,
 * control characters written out, only characters that XML allows, and never more than a bound.
 */
final class ReportText {
  /** Longest text that is shown as one line, in characters. */
  static final int MAX_LINE = 1_000;

  /** Longest message, in characters. */
  static final int MAX_MESSAGE = 10_000;

  private static final char REPLACEMENT = '\uFFFD';

  /** Lines of the output of a test, and how many there were before them. */
  record Output(int left, List<String> lines) {
    /** What stands above them. */
    String title() {
      return left == 0
          ? "output"
          : String.format(
              Locale.ROOT, "output, last %d of %d lines", lines.size(), left + lines.size());
    }
  }

  private ReportText() {}

  /** One line of at most {@link #MAX_LINE} characters or so; a line end in it is written out. */
  static String line(String text) {
    return line(text, MAX_LINE);
  }

  /** The same with another bound. */
  static String line(String text, int maxCharacters) {
    return safe(text, maxCharacters).replace("\n", "\\x0a");
  }

  /** The lines of a message of at most {@link #MAX_MESSAGE} characters or so; at least one. */
  static List<String> lines(String text) {
    List<String> lines = safe(text, MAX_MESSAGE).lines().toList();
    return lines.isEmpty() ? List.of("") : lines;
  }

  /**
   * The last lines of the output of a test: at most that many of at most that many characters
   * together, of which a line that is longer has its beginning.
   */
  static Output output(TestResult result, int maxLines, int maxCharacters) {
    List<String> all = result.output();
    List<String> last = new ArrayList<>();
    int characters = 0;
    for (int i = all.size() - 1; i >= 0 && last.size() < maxLines; i--) {
      String line = line(all.get(i), Math.min(maxCharacters, MAX_MESSAGE));
      characters += line.length() + 1;
      if (characters > maxCharacters && !last.isEmpty()) {
        break;
      }
      last.add(line);
    }
    Collections.reverse(last);
    return new Output(all.size() - last.size(), last);
  }

  /** The lines of a message that says why a test is red. */
  static List<String> message(TestResult result) {
    return lines(result.failure().map(TestFailure::message).orElse(status(result.status())));
  }

  /** A status as people say it. */
  static String status(TestStatus status) {
    return switch (status) {
      case PASSED -> "passed";
      case FAILED -> "failed";
      case ERROR -> "error";
      case TIMED_OUT -> "timed out";
      case SKIPPED -> "skipped";
    };
  }

  /** What is told of a file of which no test could run, when no problem is told. */
  static List<String> problems(BrokenTestFile broken) {
    return broken.problems().isEmpty()
        ? List.of(line(broken.file()) + ": error: no test of it could run")
        : broken.problems().stream().flatMap(each -> lines(each).stream()).toList();
  }

  /** What is told of a file, as lines that are visible. */
  static Stream<String> warnings(List<String> warnings) {
    return warnings.stream().flatMap(each -> lines(each).stream());
  }

  /** A time of a test in seconds, to the millisecond: {@code 0.046}. */
  static String seconds(double timeS) {
    return String.format(Locale.ROOT, "%.3f", timeS);
  }

  /** A time of many tests for people: {@code 0.046 s}, {@code 3.2 s}, {@code 12 min 5 s}. */
  static String duration(double timeS) {
    if (timeS < 1) {
      return seconds(timeS) + " s";
    }
    if (timeS < 59.95) {
      return String.format(Locale.ROOT, "%.1f s", timeS);
    }
    long s = Math.round(timeS);
    return s < 3600
        ? s / 60 + " min " + s % 60 + " s"
        : s / 3600 + " h " + (s % 3600) / 60 + " min";
  }

  /** {@code 1 file}, {@code 3 files}. */
  static String count(long count, String word) {
    return count + " " + word + (count == 1 ? "" : "s");
  }

  private static String safe(String text, int maxCharacters) {
    if (text.length() <= maxCharacters) {
      return allowed(VisibleText.of(ByteText.decoded(text)));
    }
    String cut = ByteText.decoded(text.substring(0, maxCharacters));
    return allowed(VisibleText.of(cut)) + "... (" + text.length() + " characters)";
  }

  /** Half a pair of surrogates is no character, and XML 1.0 has no U+FFFE and U+FFFF. */
  private static String allowed(String text) {
    if (text.chars().allMatch(each -> each < Character.MIN_SURROGATE)) {
      return text;
    }
    StringBuilder allowed = new StringBuilder(text.length());
    text.codePoints()
        .map(each -> isCharacter(each) ? each : REPLACEMENT)
        .forEach(allowed::appendCodePoint);
    return allowed.toString();
  }

  private static boolean isCharacter(int point) {
    boolean surrogate = point >= Character.MIN_SURROGATE && point <= Character.MAX_SURROGATE;
    return !surrogate && point != 0xFFFE && point != 0xFFFF;
  }
}
