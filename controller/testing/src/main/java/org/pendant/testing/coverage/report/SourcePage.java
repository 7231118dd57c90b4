package org.pendant.testing.coverage.report;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.pendant.testing.coverage.DecisionCoverage;
import org.pendant.testing.coverage.FileCoverage;
import org.pendant.testing.coverage.FunctionCoverage;
import org.pendant.testing.coverage.LineCoverage;

/** Source page: the text of one file with what was reached of each line, and by which tests. */
final class SourcePage {
  /** More tests than this are only counted where they are named. */
  private static final int MAX_NAMED = 30;

  private final FileCoverage file;
  private final int tests;
  private final Map<Integer, LineCoverage> lines = new HashMap<>();
  private final Map<Integer, List<String>> notes = new HashMap<>();

  /**
   * The page of a file.
   *
   * @param tests how many ran
   */
  SourcePage(FileCoverage file, int tests) {
    this.file = file;
    this.tests = tests;
    file.lines().forEach(line -> lines.put(line.line(), line));
    for (FunctionCoverage function : file.functions()) {
      if (!function.reached()) {
        note(function.line(), function.name() + " is never called");
      }
    }
    Stream.concat(file.branches().stream(), file.conditions().stream()).forEach(this::note);
  }

  private void note(DecisionCoverage decision) {
    boolean told = lines.containsKey(decision.line()) && !lines.get(decision.line()).reached();
    if (!decision.missing().isEmpty() && !told) {
      note(decision.line(), decision.text() + ": " + decision.missing());
    }
  }

  private void note(int line, String text) {
    notes.computeIfAbsent(line, _ -> new ArrayList<>()).add(text);
  }

  String body() {
    StringBuilder body = new StringBuilder();
    body.append("<p><a href=\"index.html\">All files</a></p>\n<h1>");
    body.append(HtmlPage.escaped(file.file())).append("</h1>\n<p>Statements ");
    body.append(HtmlPage.share(file.statements())).append(" &emsp;Branches ");
    body.append(HtmlPage.share(file.branchWays())).append(" &emsp;Conditions ");
    body.append(HtmlPage.share(file.conditionWays())).append(" &emsp;Functions ");
    body.append(HtmlPage.share(file.calledFunctions())).append("</p>\n");
    body.append("<p class=\"legend\"><span class=\"hit\">reached</span>");
    body.append("<span class=\"part\">! in part</span><span class=\"miss\">0 not reached</span>");
    body.append("The number beside a line is that of the tests that reach it; point at it for");
    body.append(" their names.</p>\n<table class=\"source\">\n");
    int last = lines.keySet().stream().mapToInt(Integer::intValue).max().orElse(0);
    for (int line = 1; line <= Math.max(last, file.text().size()); line++) {
      row(body, line, line <= file.text().size() ? file.text().get(line - 1) : "");
    }
    return body.append("</table>\n").toString();
  }

  private void row(StringBuilder body, int line, String text) {
    Optional<LineCoverage> coverage = Optional.ofNullable(lines.get(line));
    List<String> missing = notes.getOrDefault(line, List.of());
    String kind = coverage.map(each -> kind(each, missing)).orElse(missing.isEmpty() ? "" : "miss");
    body.append("<tr id=\"L").append(line).append('"');
    body.append(kind.isEmpty() ? "" : " class=\"" + kind + "\"").append("><td class=\"number\">");
    body.append(line).append("</td><td class=\"tests\"");
    coverage.ifPresent(
        each ->
            body.append(" title=\"")
                .append(HtmlPage.escaped(told(each)))
                .append("\">")
                .append(kind.equals("part") ? "! " : "")
                .append(each.tests().size()));
    body.append(coverage.isPresent() ? "" : ">").append("</td><td>");
    body.append(HtmlPage.escaped(text));
    if (!missing.isEmpty()) {
      body.append("  <span class=\"note\">");
      body.append(HtmlPage.escaped(String.join("; ", missing))).append("</span>");
    }
    body.append("</td></tr>\n");
  }

  private static String kind(LineCoverage line, List<String> missing) {
    if (!line.reached()) {
      return "miss";
    }
    boolean whole = line.statements().reached() == line.statements().total();
    return whole && missing.isEmpty() ? "hit" : "part";
  }

  private String told(LineCoverage line) {
    List<String> names = line.tests();
    if (names.isEmpty()) {
      return "no test reaches it";
    }
    String more = names.size() > MAX_NAMED ? ", ..." : "";
    return names.stream()
        .limit(MAX_NAMED)
        .collect(Collectors.joining(", ", names.size() + " of " + tests + " tests: ", more));
  }
}
