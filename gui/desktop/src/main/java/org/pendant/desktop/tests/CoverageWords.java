package org.pendant.desktop.tests;

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
        ? "Coverage" + GAP + "the tests run no program"
        : "Coverage" + GAP + report.statements().percent() + " of statements";
  }

  /** A file in the tree. */
  static String row(CoveredFile file) {
    return file.name()
        + GAP
        + file.share().percent()
        + (file.nodes().isPresent() ? " of nodes" : "");
  }

  /** All that is known of a file. */
  static String details(CoveredFile file) {
    StringJoiner text = new StringJoiner("\n");
    text.add("What the tests reach of " + file.name());
    file.nodes().ifPresent(tree -> text.add(nodes(tree)));
    file.lines().ifPresent(lines -> text.add(shares(lines)));
    if (file.nodes().isEmpty()) {
      file.lines()
          .map(FileCoverage::missing)
          .filter(missing -> !missing.isEmpty())
          .ifPresent(missing -> text.add("Lines that are not reached: " + missing));
    }
    return text.toString();
  }

  /** All files together. */
  static String details(CoverageReport report) {
    StringJoiner text = new StringJoiner("\n");
    text.add("What " + tests(report.tests().size()) + " reached of the programs");
    text.add(share("Statements", report.statements()));
    text.add(share("Ways of branches", report.branchWays()));
    text.add(share("Truths of conditions", report.conditionWays()));
    text.add(share("Functions", report.calledFunctions()));
    if (!report.trees().isEmpty()) {
      text.add(share("Nodes of trees", report.nodes()));
    }
    return text.toString();
  }

  private static String tests(int number) {
    return number == 1 ? "1 test" : number + " tests";
  }

  private static String shares(FileCoverage file) {
    return String.join(
        "\n",
        share("Statements", file.statements()),
        share("Ways of branches", file.branchWays()),
        share("Truths of conditions", file.conditionWays()),
        share("Functions", file.calledFunctions()));
  }

  private static String nodes(TreeCoverage tree) {
    List<NodeCoverage> missing = tree.nodes().stream().filter(each -> !each.reached()).toList();
    String names =
        missing.stream()
            .limit(MAX_NODES)
            .map(each -> each.number() + " " + each.label())
            .collect(Collectors.joining("\n  ", "\n  ", ""));
    String more = missing.size() > MAX_NODES ? "\n  and more" : "";
    return share("Nodes", tree.share())
        + (missing.isEmpty() ? "" : "\nNodes that are not reached:" + names + more);
  }

  private static String share(String what, Share share) {
    return share.total() == 0
        ? what + ": there are none"
        : what + ": " + share.percent() + ", " + share.reached() + " of " + share.total();
  }
}
