package org.pendant.testing.coverage;

import java.util.ArrayList;
import java.util.List;

/**
 * File coverage: one file of programs, in all tests together.
 *
 * @param file its name as it was given
 * @param text its lines, as far as they were compiled
 * @param lines on which statements begin, in their order
 * @param functions in the order of the text
 * @param branches conditions of statements, in the order of the text
 * @param conditions operands of {@code and} and {@code or}, in the order of the text
 */
public record FileCoverage(
    String file,
    List<String> text,
    List<LineCoverage> lines,
    List<FunctionCoverage> functions,
    List<DecisionCoverage> branches,
    List<DecisionCoverage> conditions) {
  public FileCoverage {
    text = List.copyOf(text);
    lines = List.copyOf(lines);
    functions = List.copyOf(functions);
    branches = List.copyOf(branches);
    conditions = List.copyOf(conditions);
  }

  /** How many statements were reached. */
  public Share statements() {
    return Share.of(lines, LineCoverage::statements);
  }

  /** How many lines with statements were reached. */
  public Share reachedLines() {
    return Share.of(lines, line -> new Share(line.reached() ? 1 : 0, 1));
  }

  /** How many ways of branches were taken. */
  public Share branchWays() {
    return Share.of(branches, DecisionCoverage::ways);
  }

  /** How many truths of operands came about. */
  public Share conditionWays() {
    return Share.of(conditions, DecisionCoverage::ways);
  }

  /** How many functions were called. */
  public Share calledFunctions() {
    return Share.of(functions, function -> new Share(function.reached() ? 1 : 0, 1));
  }

  /**
   * Lines with statements that were not reached, such as {@code 12-15, 20}; lines without a
   * statement do not part a range.
   */
  public String missing() {
    List<String> ranges = new ArrayList<>();
    int first = 0;
    int last = 0;
    for (LineCoverage line : lines) {
      boolean missing = line.statements().reached() < line.statements().total();
      if (missing) {
        first = first == 0 ? line.line() : first;
        last = line.line();
      } else if (first > 0) {
        ranges.add(range(first, last));
        first = 0;
      }
    }
    if (first > 0) {
      ranges.add(range(first, last));
    }
    return String.join(", ", ranges);
  }

  private static String range(int first, int last) {
    return first == last ? Integer.toString(first) : first + "-" + last;
  }
}
