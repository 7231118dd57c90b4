package org.pendant.testing.coverage.report;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.pendant.testing.coverage.CoverageReport;
import org.pendant.testing.coverage.FileCoverage;
import org.pendant.testing.coverage.NodeCoverage;
import org.pendant.testing.coverage.TreeCoverage;
import org.pendant.text.Language;
import org.pendant.text.TerminalColumns;
import org.pendant.text.Texts;

/** Coverage table: coverage as a table for people, a file a row. */
public final class CoverageTable {
  private final Texts texts;

  private CoverageTable(Texts texts) {
    this.texts = texts;
  }

  /** The table in English; its lines end with a line feed, and there are none without a file. */
  public static String of(CoverageReport report) {
    return of(report, Texts.of(CoverageTable.class, Language.ENGLISH));
  }

  /** The table in the language of {@code texts}, which are those of this package. */
  public static String of(CoverageReport report, Texts texts) {
    return new CoverageTable(texts).text(report);
  }

  private String text(CoverageReport report) {
    if (report.files().isEmpty() && report.trees().isEmpty()) {
      return "";
    }
    List<List<String>> rows = new ArrayList<>();
    rows.add(
        List.of(
            texts.get("file"),
            texts.get("statements"),
            texts.get("branches"),
            texts.get("conditions"),
            texts.get("functions"),
            texts.get("missingLines")));
    report.files().forEach(file -> rows.add(row(file)));
    if (report.files().size() > 1) {
      rows.add(
          List.of(
              texts.get("allFiles"),
              report.statements().percent(),
              report.branchWays().percent(),
              report.conditionWays().percent(),
              report.calledFunctions().percent(),
              ""));
    }
    StringBuilder text = new StringBuilder();
    int[] widths = widths(rows);
    rows.forEach(row -> append(text, row, widths));
    report.trees().forEach(tree -> append(text, tree));
    return text.toString();
  }

  private static List<String> row(FileCoverage file) {
    return List.of(
        file.file(),
        file.statements().percent(),
        file.branchWays().percent(),
        file.conditionWays().percent(),
        file.calledFunctions().percent(),
        file.missing());
  }

  private static int[] widths(List<List<String>> rows) {
    int[] widths = new int[rows.getFirst().size()];
    for (List<String> row : rows) {
      for (int i = 0; i < widths.length; i++) {
        widths[i] = Math.max(widths[i], TerminalColumns.of(row.get(i)));
      }
    }
    return widths;
  }

  private static void append(StringBuilder text, List<String> row, int[] widths) {
    StringBuilder line = new StringBuilder();
    for (int i = 0; i < widths.length; i++) {
      String cell = row.get(i);
      String space = " ".repeat(widths[i] - TerminalColumns.of(cell));
      boolean words = i == 0 || i == widths.length - 1;
      line.append(i == 0 ? "" : "  ").append(words ? cell + space : space + cell);
    }
    text.append(line.toString().stripTrailing()).append('\n');
  }

  private void append(StringBuilder text, TreeCoverage tree) {
    int reached = tree.share().reached();
    int total = tree.share().total();
    String missing =
        tree.nodes().stream()
            .filter(node -> !node.reached())
            .map(CoverageTable::name)
            .collect(Collectors.joining(", "));
    text.append(
            missing.isEmpty()
                ? texts.get("nodesReached", tree.file(), reached, total)
                : texts.get("nodesReachedBut", tree.file(), reached, total, missing))
        .append('\n');
  }

  private static String name(NodeCoverage node) {
    return node.number() + " \"" + node.label() + "\"";
  }
}
