package org.pendant.testing.coverage;

import java.util.List;

/**
 * Coverage report: what all tests together have reached. The same tests give an equal report,
 * whatever order they ran in.
 *
 * @param tests all that ran, sorted
 * @param files sorted by their names
 * @param trees sorted by their names
 */
public record CoverageReport(
    List<String> tests, List<FileCoverage> files, List<TreeCoverage> trees) {
  public CoverageReport {
    tests = List.copyOf(tests);
    files = List.copyOf(files);
    trees = List.copyOf(trees);
  }

  /** How many statements were reached. */
  public Share statements() {
    return Share.of(files, FileCoverage::statements);
  }

  /** How many lines with statements were reached. */
  public Share reachedLines() {
    return Share.of(files, FileCoverage::reachedLines);
  }

  /** How many ways of branches were taken. */
  public Share branchWays() {
    return Share.of(files, FileCoverage::branchWays);
  }

  /** How many truths of operands came about. */
  public Share conditionWays() {
    return Share.of(files, FileCoverage::conditionWays);
  }

  /** How many functions were called. */
  public Share calledFunctions() {
    return Share.of(files, FileCoverage::calledFunctions);
  }

  /** How many nodes of trees were reached. */
  public Share nodes() {
    return Share.of(trees, TreeCoverage::share);
  }
}
