package org.pendant.desktop.tests;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.StringJoiner;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestPlace;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;
import org.pendant.testing.source.TestCase;

/** Test words: what the panel says of tests. */
final class TestWords {
  private static final int OUTPUT_LINES = 40;
  private static final int SLOWEST = 5;
  private static final String GAP = "   ";

  private TestWords() {}

  /** The line above the tree. */
  static String summary(TestsPresenter presenter) {
    int all = presenter.done() + presenter.toDo();
    if (presenter.running() && (all > 0 || presenter.stopping())) {
      return presenter.stopping()
          ? "Stopping\u2026"
          : "Running: " + presenter.done() + " of " + count(all, "test");
    }
    if (presenter.running() || presenter.looking()) {
      return "Looking for tests\u2026";
    }
    if (!presenter.trouble().isEmpty()) {
      return "Not run: " + presenter.trouble();
    }
    return presenter.last().map(TestWords::summary).orElseGet(() -> found(presenter));
  }

  private static String found(TestsPresenter presenter) {
    int tests = presenter.files().stream().mapToInt(each -> each.tests().size()).sum();
    return count(tests, "test") + " in " + count(presenter.files().size(), "file");
  }

  private static String summary(SuiteResult result) {
    StringJoiner words = new StringJoiner(", ");
    long red = result.results().stream().filter(each -> each.status().red()).count();
    add(words, red, "red");
    add(
        words,
        result.broken().size(),
        result.broken().size() == 1 ? "broken file" : "broken files");
    words.add(result.count(TestStatus.PASSED) + " passed");
    add(words, result.count(TestStatus.SKIPPED), "skipped");
    add(words, result.notRun(), "not run");
    return words.toString();
  }

  /** What else is to be said of the last run; empty where there was none. */
  static String more(TestsPresenter presenter) {
    return presenter
        .last()
        .map(
            each ->
                String.format(
                    Locale.ROOT,
                    "Took %.1f s on this computer. pendant test --seed %d has the same random"
                        + " numbers.",
                    each.wallTimeS(),
                    each.seed()))
        .orElse("");
  }

  private static void add(StringJoiner words, long number, String what) {
    if (number > 0) {
      words.add(number + " " + what);
    }
  }

  private static String count(int number, String word) {
    return (number == 0 ? "no" : Integer.toString(number)) + " " + word + (number == 1 ? "" : "s");
  }

  /** A test in the tree, with the robot time that it took. */
  static String row(TestsPresenter presenter, TestCase test) {
    return switch (presenter.mark(test.id())) {
      case NEW -> test.id().name();
      case WAITING -> test.id().name() + GAP + "\u2026";
      case SKIPPED -> test.id().name() + GAP + "skipped";
      case PASSED, RED ->
          test.id().name()
              + presenter
                  .result(test.id())
                  .map(each -> String.format(Locale.ROOT, GAP + "%.3f s", each.robotTimeS()))
                  .orElse("");
    };
  }

  /** A file in the tree, with how many of its tests hold. */
  static String row(TestsPresenter presenter, FoundFile file) {
    long known =
        file.tests().stream().filter(each -> presenter.result(each.id()).isPresent()).count();
    long passed =
        file.tests().stream().filter(each -> presenter.mark(each.id()) == TestMark.PASSED).count();
    if (!file.problems().isEmpty()) {
      return file.name() + GAP + "cannot run";
    }
    return known == 0
        ? file.name()
        : file.name() + GAP + passed + " of " + file.tests().size() + " passed";
  }

  /** What a screen reader says of a mark. */
  static String of(TestMark mark) {
    return switch (mark) {
      case NEW -> "not run yet";
      case WAITING -> "running";
      case PASSED -> "passed";
      case RED -> "red";
      case SKIPPED -> "skipped";
    };
  }

  /** What is said while nothing is chosen: what came of the last run, and what can be done. */
  static String overview(TestsPresenter presenter) {
    if (presenter.running()) {
      return summary(presenter);
    }
    StringJoiner lines = new StringJoiner("\n");
    lines.add(found(presenter) + presenter.folder().map(each -> " below " + each).orElse("") + ".");
    presenter.last().ifPresent(result -> addLast(lines, presenter, result));
    lines.add("");
    lines.add(
        "Run all runs them in controllers of their own: the robot of the window stands where it is."
            + " Choose a test or a file to see what came of it; Ctrl+Enter runs what is chosen,"
            + " Ctrl+Shift+Enter debugs a test, Enter shows where it is written.");
    return lines.toString();
  }

  private static void addLast(StringJoiner lines, TestsPresenter presenter, SuiteResult result) {
    lines.add("Last run: " + summary(result) + ". " + more(presenter));
    List<TestResult> slowest =
        result.results().stream()
            .sorted(Comparator.comparingDouble(TestResult::wallTimeS).reversed())
            .limit(SLOWEST)
            .toList();
    if (slowest.size() > 1) {
      lines.add("");
      lines.add("What took longest on this computer:");
      slowest.forEach(
          each ->
              lines.add(
                  each.id().name() + String.format(Locale.ROOT, GAP + "%.1f s", each.wallTimeS())));
    }
  }

  /** All that is known of a test. */
  static String details(TestsPresenter presenter, TestCase test) {
    return presenter
        .result(test.id())
        .map(TestWords::details)
        .orElseGet(() -> test.id().name() + " has not run yet.");
  }

  private static String details(TestResult result) {
    StringJoiner lines = new StringJoiner("\n");
    Optional<TestFailure> failure = result.failure();
    if (failure.isPresent()) {
      lines.add(failure.get().message());
      failure.get().place().ifPresent(place -> lines.add("at " + at(place)));
      failure.get().stack().forEach(place -> lines.add("called from " + at(place)));
    } else if (result.status() == TestStatus.SKIPPED) {
      lines.add("Skipped: " + result.skipped());
    } else {
      lines.add(
          String.format(
              Locale.ROOT,
              "%s passed: %.3f s of robot time, %.3f s on this computer.",
              result.id().name(),
              result.robotTimeS(),
              result.wallTimeS()));
    }
    if (!result.output().isEmpty()) {
      int from = Math.max(0, result.output().size() - OUTPUT_LINES);
      lines.add("");
      lines.add(from > 0 ? "The last lines of its log:" : "Its log:");
      result.output().subList(from, result.output().size()).forEach(lines::add);
    }
    return lines.toString();
  }

  private static String at(TestPlace place) {
    return place.text() + (place.function().isEmpty() ? "" : " in " + place.function());
  }

  /** All that is known of a file. */
  static String details(FoundFile file) {
    return file.problems().isEmpty()
        ? count(file.tests().size(), "test") + " in " + file.name()
        : String.join("\n", file.problems());
  }

  /** Why there is nothing in the tree. */
  static String empty(TestsPresenter presenter) {
    if (presenter.folder().isEmpty()) {
      return "Tests are in files beside the program: save it first.";
    }
    if (presenter.looking()) {
      return "Looking for tests in " + presenter.folder().get() + "\u2026";
    }
    return presenter.trouble().isEmpty()
        ? "No tests yet: write functions that are called test_\u2026 in a file *_test.script in "
            + presenter.folder().get()
            + "."
        : "Not found: " + presenter.trouble();
  }
}
