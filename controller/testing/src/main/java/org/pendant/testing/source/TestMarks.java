package org.pendant.testing.source;

import static org.pendant.testing.source.SourceTexts.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.models.arm.Joints;

/**
 * Test marks: what stands in the comment lines right above a test, each in a line of its own:
 * {@code # @tag slow}, {@code # @skip REASON}, {@code # @timeout SECONDS}, {@code #
 * @start_at JOINTS}, {@code # @scene FILE}, {@code # @case ARGUMENTS}, {@code # @given RUNS}, {@code # @example CHOICES}, {@code # @golden TOLERANCES}.
 *
 * @param tags sorted
 * @param skip why it does not run
 * @param timeoutS how much robot time it may take
 * @param startRad where the arm stands at first
 * @param scene the file of what stands around the arm
 * @param cases the arguments of each case, in order
 * @param property how it is run with many values
 * @param golden how it is compared with a recording
 */
record TestMarks(
    SortedSet<String> tags,
    Optional<String> skip,
    OptionalDouble timeoutS,
    Optional<Joints> startRad,
    Optional<Case> scene,
    List<Case> cases,
    Optional<TestCase.Property> property,
    Optional<GoldenMark> golden) {
  TestMarks {
    tags = Collections.unmodifiableSortedSet(tags);
    cases = List.copyOf(cases);
  }

  /**
   * One case of a table.
   *
   * @param arguments as they stand there
   * @param range where they stand
   */
  record Case(String arguments, SourceRange range) {}

  /**
   * Reads the marks above a line.
   *
   * @param line of the definition, 1-based
   * @param problems takes what is wrong with them
   */
  static TestMarks above(Source source, int line, List<Diagnostic> problems) {
    int first = line;
    while (first > 1 && source.lineText(first - 1).strip().startsWith("#")) {
      first--;
    }
    Reading reading = new Reading(source, problems);
    for (int each = first; each < line; each++) {
      reading.line(each);
    }
    return new TestMarks(
        reading.tags,
        reading.skip,
        reading.timeoutS,
        reading.startRad,
        reading.scene,
        reading.cases,
        reading.property(),
        reading.golden());
  }

  /** Marks as far as they are read. */
  private static final class Reading {
    private static final Pattern RUNS = Pattern.compile("[1-9]\\d{0,5}");
    private static final double MAX_DEGREES = 360;
    private static final Pattern TAG = Pattern.compile("[^,\\s]+");

    private final Source source;
    private final List<Diagnostic> problems;
    private final SortedSet<String> tags = new TreeSet<>();
    private final List<Case> cases = new ArrayList<>();
    private Optional<String> skip = Optional.empty();
    private OptionalDouble timeoutS = OptionalDouble.empty();
    private Optional<Joints> startRad = Optional.empty();
    private Optional<Case> scene = Optional.empty();
    private final List<List<Double>> examples = new ArrayList<>();
    private Optional<GoldenMark> golden = Optional.empty();
    private SourceRange goldenRange = new SourceRange(0, 1);
    private int runs;

    Reading(Source source, List<Diagnostic> problems) {
      this.source = source;
      this.problems = problems;
    }

    private void line(int line) {
      String text = source.lineText(line);
      int at = text.indexOf('@');
      if (at < 0 || !text.substring(0, at).strip().equals("#")) {
        return;
      }
      int end = at + 1;
      while (end < text.length() && !Character.isWhitespace(text.charAt(end))) {
        end++;
      }
      String word = text.substring(at + 1, end);
      String rest = text.substring(end).strip();
      int start = source.lineStart(line);
      int from = start + (rest.isEmpty() ? at : text.indexOf(rest, end));
      SourceRange range = new SourceRange(from, from + Math.max(1, rest.length()));
      switch (word) {
        case "tag", "tags" -> tags(rest, range);
        case "skip" -> skip = Optional.of(rest.isEmpty() ? text("noReason") : rest);
        case "timeout" -> timeout(rest, range);
        case "start_at" -> start(rest, range);
        case "scene" -> scene = Optional.of(new Case(rest, range));
        case "case" -> cases.add(new Case(rest, range));
        case "given" -> given(rest, range);
        case "example" -> example(rest, range);
        case "golden" -> golden(rest, range);
        default -> problems.add(Diagnostic.error("unknown-mark", range, text("noMark", word), ""));
      }
    }

    private void tags(String rest, SourceRange range) {
      Matcher tag = TAG.matcher(rest);
      while (tag.find()) {
        tags.add(tag.group());
      }
      if (tags.isEmpty()) {
        problems.add(Diagnostic.error("empty-mark", range, text("noTag"), ""));
      }
    }

    private Optional<TestCase.Property> property() {
      return runs == 0 && examples.isEmpty()
          ? Optional.empty()
          : Optional.of(new TestCase.Property(Math.max(runs, examples.size()), examples));
    }

    private Optional<GoldenMark> golden() {
      if (golden.isPresent() && property().isPresent()) {
        problems.add(Diagnostic.error("wrong-mark", goldenRange, text("goldenVaries"), ""));
      }
      return golden;
    }

    private void golden(String rest, SourceRange range) {
      goldenRange = range;
      golden = GoldenMark.of(rest);
      if (golden.isEmpty()) {
        problems.add(Diagnostic.error("wrong-mark", range, text("wrongGolden", rest), ""));
      }
    }

    private void given(String rest, SourceRange range) {
      if (RUNS.matcher(rest).matches()) {
        runs = Integer.parseInt(rest);
      } else {
        problems.add(Diagnostic.error("wrong-mark", range, text("wrongGiven", rest), ""));
      }
    }

    private void example(String rest, SourceRange range) {
      List<Double> choices = new ArrayList<>();
      Matcher number = TAG.matcher(rest);
      while (number.find()) {
        choices.add(choice(number.group()));
      }
      if (choices.stream().allMatch(each -> each >= 0 && each < 1)) {
        examples.add(choices);
      } else {
        problems.add(Diagnostic.error("wrong-mark", range, text("wrongExample", rest), ""));
      }
    }

    private static double choice(String text) {
      try {
        return Double.parseDouble(text);
      } catch (NumberFormatException _) {
        // outside of the range of choices, as everything else that is none
        return -1;
      }
    }

    private void start(String rest, SourceRange range) {
      double[] degrees =
          TAG.matcher(rest).results().mapToDouble(each -> degrees(each.group())).toArray();
      if (degrees.length == Joints.COUNT
          && Arrays.stream(degrees).allMatch(each -> Math.abs(each) <= MAX_DEGREES)) {
        startRad = Optional.of(Joints.of(Arrays.stream(degrees).map(Math::toRadians).toArray()));
        return;
      }
      problems.add(Diagnostic.error("wrong-mark", range, text("wrongStart", rest), ""));
    }

    private static double degrees(String text) {
      try {
        return Double.parseDouble(text);
      } catch (NumberFormatException _) {
        // outside of the range of joints, as everything else that is none
        return Double.NaN;
      }
    }

    private void timeout(String rest, SourceRange range) {
      try {
        double seconds = Double.parseDouble(rest);
        if (seconds > 0 && seconds < Double.POSITIVE_INFINITY) {
          timeoutS = OptionalDouble.of(seconds);
          return;
        }
      } catch (NumberFormatException _) {
        // said below, as of any other text that is no time
      }
      problems.add(Diagnostic.error("wrong-mark", range, text("wrongTimeout", rest), ""));
    }
  }
}
