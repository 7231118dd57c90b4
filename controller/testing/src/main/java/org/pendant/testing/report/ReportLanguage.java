package org.pendant.testing.report;

import java.util.List;
import java.util.function.UnaryOperator;
import org.pendant.testing.TestStatus;
import org.pendant.text.Language;
import org.pendant.text.Texts;

/**
 * Report language: in which language a report speaks to people. Reports that are files are in
 * English; what a terminal shows may be in another.
 */
public final class ReportLanguage {
  static final ReportLanguage ENGLISH =
      new ReportLanguage(
          Texts.of(ReportLanguage.class, Language.ENGLISH), UnaryOperator.identity());

  private final Texts texts;
  private final UnaryOperator<String> shown;

  /**
   * A language.
   *
   * @param texts of this package in that language
   * @param shown says in it what others have said in English
   */
  public ReportLanguage(Texts texts, UnaryOperator<String> shown) {
    this.texts = texts;
    this.shown = shown;
  }

  String text(String key, Object... values) {
    return texts.get(key, values);
  }

  /** What others have said in English, such as why a test is red. */
  String shown(String english) {
    return shown.apply(english);
  }

  /** The lines of a message. */
  List<String> shown(List<String> english) {
    return english.size() == 1
        ? List.of(shown(english.getFirst()))
        : List.of(shown(String.join("\n", english)).split("\n", -1));
  }

  /** So many of a thing: {@code 1 file}, {@code 3 files}. */
  String count(int count, String one, String several) {
    return text(count == 1 ? one : several, count);
  }

  /** Two parts of a list. */
  String listed(String first, String second) {
    return first.isEmpty() ? second : text("listed", first, second);
  }

  /** How many tests had an end. */
  String count(int count, TestStatus status) {
    return switch (status) {
      case PASSED -> text("passedCount", count);
      case FAILED -> text("failedCount", count);
      case ERROR -> count(count, "oneError", "errors");
      case TIMED_OUT -> text("timedOutCount", count);
      case SKIPPED -> text("skippedCount", count);
    };
  }

  /** What tests, programs and popups say, under its kind where it begins with one. */
  String output(String line) {
    if (line.startsWith("popup: ")) {
      return text("popup", line.substring("popup: ".length()));
    }
    if (line.startsWith("error: ")) {
      return text("error", shown(line.substring("error: ".length())));
    }
    return line.startsWith("target: ")
        ? text("target", shown(line.substring("target: ".length())))
        : line;
  }
}
