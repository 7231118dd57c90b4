package org.pendant.desktop.tests;

import static org.pendant.desktop.tests.TestsTexts.text;

import java.util.List;
import java.util.StringJoiner;
import java.util.stream.Collectors;
import org.pendant.testing.coverage.CoverageReport;
import org.pendant.testing.coverage.FileCoverage;
import org.pendant.testing.coverage.NodeCoverage;
import org.pendant.testing.coverage.Share;
import org.pendant.testing.coverage.TreeCoverage;

/** Coverage words: what the panel says of what tests have reached. */
final class CoverageWords {
  private static final String GAP = "   ";
  private static final int MAX_NODES = 40;

  private CoverageWords() {}

  /** All files together, in the tree. */
  static String row(CoverageReport report) {
    return report.files().isEmpty() && report.trees().isEmpty()
        ? text("coverage") + GAP + text("theTestsRunNoProgram")
        : text("coverage") + GAP + text("ofStatements", report.statements().percent());
  }

  /** A file in the tree. */
  static String row(CoveredFile file) {
    String percent = file.share().percent();
    return file.name() + GAP + (file.nodes().isPresent() ? text("ofNodes", percent) : percent);
  }

  /** All that is known of a file. */
  static String details(CoveredFile file) {
    StringJoiner lines = new StringJoiner("\n");
    lines.add(text("whatTheTestsReachOf", file.name()));
    file.nodes().ifPresent(tree -> lines.add(nodes(tree)));
    file.lines().ifPresent(covered -> lines.add(shares(covered)));
    if (file.nodes().isEmpty()) {
      file.lines()
          .map(FileCoverage::missing)
          .filter(missing -> !missing.isEmpty())
          .ifPresent(missing -> lines.add(text("linesNotReached", missing)));
    }
    return lines.toString();
  }

  /** All files together. */
  static String details(CoverageReport report) {
    StringJoiner lines = new StringJoiner("\n");
    int tests = report.tests().size();
    lines.add(tests == 1 ? text("whatOneTestReached") : text("whatTestsReached", tests));
    lines.add(share(text("statements"), report.statements()));
    lines.add(share(text("waysOfBranches"), report.branchWays()));
    lines.add(share(text("truthsOfConditions"), report.conditionWays()));
    lines.add(share(text("functions"), report.calledFunctions()));
    if (!report.trees().isEmpty()) {
      lines.add(share(text("nodesOfTrees"), report.nodes()));
    }
    return lines.toString();
  }

  private static String shares(FileCoverage file) {
    return String.join(
        "\n",
        share(text("statements"), file.statements()),
        share(text("waysOfBranches"), file.branchWays()),
        share(text("truthsOfConditions"), file.conditionWays()),
        share(text("functions"), file.calledFunctions()));
  }

  private static String nodes(TreeCoverage tree) {
    List<NodeCoverage> missing = tree.nodes().stream().filter(each -> !each.reached()).toList();
    String names =
        missing.stream()
            .limit(MAX_NODES)
            .map(each -> each.number() + " " + each.label())
            .collect(Collectors.joining("\n  ", "\n  ", ""));
    String more = missing.size() > MAX_NODES ? "\n  " + text("andMore") : "";
    return share(text("nodes"), tree.share())
        + (missing.isEmpty() ? "" : "\n" + text("nodesNotReached") + names + more);
  }

  private static String share(String what, Share share) {
    return share.total() == 0
        ? text("thereAreNone", what)
        : text("share", what, share.percent(), share.reached(), share.total());
  }
}
