package org.pendant.testing;

import java.util.List;
import java.util.Optional;

/**
 * Suite result: everything that one call of the runner found and ran.
 *
 * @param results in the order of files and of the tests in them, whatever order they ran in
 * @param broken what is wrong with files of which no test could run
 * @param warnings what people should look at in files
 * @param seed of the random order
 * @param notRun tests that were left out after the first red one
 * @param wallTimeS how long everything took; no part of what must repeat
 */
public record SuiteResult(
    List<TestResult> results,
    List<BrokenTestFile> broken,
    List<FileWarnings> warnings,
    long seed,
    int notRun,
    double wallTimeS) {
  public SuiteResult {
    results = List.copyOf(results);
    broken = List.copyOf(broken);
    warnings = List.copyOf(warnings);
  }

  /** One without warnings. */
  public SuiteResult(
      List<TestResult> results,
      List<BrokenTestFile> broken,
      long seed,
      int notRun,
      double wallTimeS) {
    this(results, broken, List.of(), seed, notRun, wallTimeS);
  }

  /** The warnings about one file. */
  public List<String> warningsOf(String file) {
    return warnings.stream()
        .filter(each -> each.file().equals(file))
        .flatMap(each -> each.lines().stream())
        .toList();
  }

  /** How many tests have that status. */
  public long count(TestStatus status) {
    return results.stream().filter(each -> each.status() == status).count();
  }

  /** Whether a test is red or a file is broken. */
  public boolean red() {
    return !broken.isEmpty() || results.stream().anyMatch(each -> each.status().red());
  }

  /** The first red test in the order of the report. */
  public Optional<TestResult> firstRed() {
    return results.stream().filter(each -> each.status().red()).findFirst();
  }
}
