package org.pendant.desktop.tests;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.testing.coverage.CoverageReport;
import org.pendant.testing.coverage.FileCoverage;
import org.pendant.testing.coverage.Share;
import org.pendant.testing.coverage.TreeCoverage;

/**
 * Covered file: a program, and what the tests have reached of it.
 *
 * @param name below the folder of the tests
 * @param lines of it; empty for a tree whose file has no lines for people
 * @param nodes of it; empty for a script
 */
record CoveredFile(String name, Optional<FileCoverage> lines, Optional<TreeCoverage> nodes) {

  /** Those of a report, sorted by their names. */
  static List<CoveredFile> of(CoverageReport report) {
    List<CoveredFile> all = new ArrayList<>();
    for (FileCoverage file : report.files()) {
      all.add(new CoveredFile(file.file(), Optional.of(file), tree(report, file.file())));
    }
    for (TreeCoverage tree : report.trees()) {
      if (all.stream().noneMatch(each -> each.name().equals(tree.file()))) {
        all.add(new CoveredFile(tree.file(), Optional.empty(), Optional.of(tree)));
      }
    }
    return all;
  }

  private static Optional<TreeCoverage> tree(CoverageReport report, String name) {
    return report.trees().stream().filter(each -> each.file().equals(name)).findFirst();
  }

  /** What stands behind its name: nodes of a tree, statements of a script. */
  Share share() {
    return nodes.map(TreeCoverage::share).orElseGet(() -> lines.orElseThrow().statements());
  }

  /** The first line that is not reached whole, as far as lines mean something; else the first. */
  int firstMissing() {
    return lines
        .filter(_ -> nodes.isEmpty())
        .flatMap(
            file ->
                file.lines().stream()
                    .filter(line -> line.statements().reached() < line.statements().total())
                    .findFirst())
        .map(line -> line.line())
        .orElse(1);
  }
}
