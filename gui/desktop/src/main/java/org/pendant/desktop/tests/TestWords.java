package org.pendant.desktop.tests;

import static org.pendant.desktop.tests.TestsTexts.text;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.StringJoiner;
import org.pendant.kit.text.Messages;
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
          ? text("stopping")
          : text("running", presenter.done(), tests(all));
    }
    if (presenter.running() || presenter.looking()) {
      return text("lookingForTests");
    }
    if (!presenter.trouble().isEmpty()) {
      return text("notRun", presenter.trouble());
    }
    return presenter.last().map(TestWords::summary).orElseGet(() -> found(presenter));
  }

  private static String found(TestsPresenter presenter) {
    int tests = presenter.files().stream().mapToInt(each -> each.tests().size()).sum();
    int files = presenter.files().size();
    return switch (files) {
      case 0 -> text("inNoFiles", tests(tests));
      case 1 -> text("inOneFile", tests(tests));
      default -> text("inFiles", tests(tests), files);
    };
  }

  private static String summary(SuiteResult result) {
    List<String> words = new ArrayList<>();
    long red = result.results().stream().filter(each -> each.status().red()).count();
    add(words, red, "red");
    add(words, result.broken().size(), result.broken().size() == 1 ? "brokenFile" : "brokenFiles");
    words.add(text("passedCount", result.count(TestStatus.PASSED)));
    add(words, result.count(TestStatus.SKIPPED), "skippedCount");
    add(words, result.notRun(), "notRunCount");
    return Messages.joined(words);
  }

  /** What else is to be said of the last run; empty where there was none. */
  static String more(TestsPresenter presenter) {
    return presenter
        .last()
        .map(each -> String.format(Locale.ROOT, text("tookAndSeed"), each.wallTimeS(), each.seed()))
        .orElse("");
  }

  private static void add(List<String> words, long number, String key) {
    if (number > 0) {
      words.add(text(key, number));
    }
  }

  private static String tests(int number) {
    return switch (number) {
      case 0 -> text("noTests");
      case 1 -> text("oneTest");
      default -> text("testCount", number);
    };
  }

  /** A test in the tree, with the robot time that it took. */
  static String row(TestsPresenter presenter, TestCase test) {
    return switch (presenter.mark(test.id())) {
      case NEW -> test.id().name();
      case WAITING -> test.id().name() + GAP + "\u2026";
      case SKIPPED -> test.id().name() + GAP + text("skipped");
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
      return file.name() + GAP + text("cannotRun");
    }
    return known == 0
        ? file.name()
        : file.name() + GAP + text("ofPassed", passed, file.tests().size());
  }

  /** What a screen reader says of a mark. */
  static String of(TestMark mark) {
    return switch (mark) {
      case NEW -> text("notRunYet");
      case WAITING -> text("waiting");
      case PASSED -> text("green");
      case RED -> text("redMark");
      case SKIPPED -> text("skipped");
    };
  }

  /** What is said while nothing is chosen: what came of the last run, and what can be done. */
  static String overview(TestsPresenter presenter) {
    if (presenter.running()) {
      return summary(presenter);
    }
    StringJoiner lines = new StringJoiner("\n");
    lines.add(
        presenter
            .folder()
            .map(folder -> text("foundBelow", found(presenter), folder))
            .orElseGet(() -> text("found", found(presenter))));
    presenter.last().ifPresent(result -> addLast(lines, presenter, result));
    lines.add("");
    lines.add(text("howToBegin"));
    return lines.toString();
  }

  private static void addLast(StringJoiner lines, TestsPresenter presenter, SuiteResult result) {
    lines.add(text("lastRun", summary(result), more(presenter)));
    List<TestResult> slowest =
        result.results().stream()
            .sorted(Comparator.comparingDouble(TestResult::wallTimeS).reversed())
            .limit(SLOWEST)
            .toList();
    if (slowest.size() > 1) {
      lines.add("");
      lines.add(text("whatTookLongest"));
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
        .orElseGet(() -> text("hasNotRunYet", test.id().name()));
  }

  private static String details(TestResult result) {
    StringJoiner lines = new StringJoiner("\n");
    Optional<TestFailure> failure = result.failure();
    if (failure.isPresent()) {
      lines.add(Messages.shown(failure.get().message()));
      failure.get().place().ifPresent(place -> lines.add(text("atPlace", at(place))));
      failure.get().stack().forEach(place -> lines.add(text("calledFrom", at(place))));
    } else if (result.status() == TestStatus.SKIPPED) {
      lines.add(text("skippedBecause", result.skipped()));
    } else {
      lines.add(
          String.format(
              Locale.ROOT,
              text("passedInTime"),
              result.id().name(),
              result.robotTimeS(),
              result.wallTimeS()));
    }
    if (!result.output().isEmpty()) {
      int from = Math.max(0, result.output().size() - OUTPUT_LINES);
      lines.add("");
      lines.add(text(from > 0 ? "theLastLinesOfItsLog" : "itsLog"));
      result.output().subList(from, result.output().size()).forEach(lines::add);
    }
    return lines.toString();
  }

  private static String at(TestPlace place) {
    return place.function().isEmpty()
        ? place.text()
        : text("inFunction", place.text(), place.function());
  }

  /** All that is known of a file. */
  static String details(FoundFile file) {
    return file.problems().isEmpty()
        ? text("inFile", tests(file.tests().size()), file.name())
        : String.join("\n", file.problems());
  }

  /** Why there is nothing in the tree. */
  static String empty(TestsPresenter presenter) {
    if (presenter.folder().isEmpty()) {
      return text("saveTheProgramFirst");
    }
    if (presenter.looking()) {
      return text("lookingIn", presenter.folder().get());
    }
    return presenter.trouble().isEmpty()
        ? text("noTestsYet", presenter.folder().get())
        : text("notFound", presenter.trouble());
  }
}
