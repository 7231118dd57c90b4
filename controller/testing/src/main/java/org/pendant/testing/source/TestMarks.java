package org.pendant.testing.source;

import java.util.ArrayList;
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

/**
 * Test marks: what stands in the comment lines right above a test, each in a line of its own:
 * {@code # @tag slow}, {@code # @skip REASON}, {@code # @timeout SECONDS}, {@code # @case
 * ARGUMENTS}.
 *
 * @param tags sorted
 * @param skip why it does not run
 * @param timeoutS how much robot time it may take
 * @param cases the arguments of each case, in order
 */
record TestMarks(
    SortedSet<String> tags, Optional<String> skip, OptionalDouble timeoutS, List<Case> cases) {
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
    return new TestMarks(reading.tags, reading.skip, reading.timeoutS, reading.cases);
  }

  /** Marks as far as they are read. */
  private static final class Reading {
    private static final Pattern TAG = Pattern.compile("[^,\\s]+");

    private final Source source;
    private final List<Diagnostic> problems;
    private final SortedSet<String> tags = new TreeSet<>();
    private final List<Case> cases = new ArrayList<>();
    private Optional<String> skip = Optional.empty();
    private OptionalDouble timeoutS = OptionalDouble.empty();

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
        case "skip" -> skip = Optional.of(rest.isEmpty() ? "no reason given" : rest);
        case "timeout" -> timeout(rest, range);
        case "case" -> cases.add(new Case(rest, range));
        default ->
            problems.add(
                Diagnostic.error(
                    "unknown-mark",
                    range,
                    "@" + word + " is no mark of a test; there are @tag, @skip, @timeout and @case",
                    ""));
      }
    }

    private void tags(String rest, SourceRange range) {
      Matcher tag = TAG.matcher(rest);
      while (tag.find()) {
        tags.add(tag.group());
      }
      if (tags.isEmpty()) {
        problems.add(Diagnostic.error("empty-mark", range, "@tag names no tag", ""));
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
      problems.add(
          Diagnostic.error(
              "wrong-mark",
              range,
              "@timeout is '" + rest + "', must be a number of seconds above 0",
              ""));
    }
  }
}
