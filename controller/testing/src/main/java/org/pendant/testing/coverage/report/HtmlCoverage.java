package org.pendant.testing.coverage.report;

import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.pendant.testing.coverage.CoverageReport;
import org.pendant.testing.coverage.FileCoverage;
import org.pendant.testing.coverage.NodeCoverage;
import org.pendant.testing.coverage.Share;
import org.pendant.testing.coverage.TreeCoverage;

/**
 * HTML coverage: coverage as pages for a browser: {@code index.html} with all files, and a page for
 * each file. They need nothing from anywhere else, and are light or dark as the browser is.
 */
public final class HtmlCoverage {
  private static final String INDEX = "index.html";

  private final CoverageReport report;
  private final SortedMap<String, String> pages = new TreeMap<>();
  private final SortedMap<String, String> names = new TreeMap<>();

  private HtmlCoverage(CoverageReport report) {
    this.report = report;
  }

  /** The pages, by the names of files that stand in one folder. */
  public static SortedMap<String, String> of(CoverageReport report) {
    HtmlCoverage html = new HtmlCoverage(report);
    html.write();
    return html.pages;
  }

  private void write() {
    Set<String> taken = new HashSet<>(Set.of(INDEX));
    for (FileCoverage file : report.files()) {
      names.put(file.file(), name(file.file(), taken));
    }
    pages.put("coverage.css", HtmlPage.STYLE);
    pages.put(INDEX, index());
    for (FileCoverage file : report.files()) {
      String page = names.get(file.file());
      pages.put(page, HtmlPage.of(file.file(), new SourcePage(file, report.tests().size()).body()));
    }
  }

  /** A name that every file system takes and that no other page has. */
  private static String name(String file, Set<String> taken) {
    String plain = file.replaceAll("[^A-Za-z0-9.-]", "_").replaceFirst("^\\.+", "_");
    String name = plain + ".html";
    for (int i = 2; !taken.add(name.toLowerCase(Locale.ROOT)); i++) {
      name = plain + "-" + i + ".html";
    }
    return name;
  }

  private String index() {
    StringBuilder body = new StringBuilder();
    int tests = report.tests().size();
    body.append("<h1>Coverage</h1>\n<p>").append(tests).append(tests == 1 ? " test" : " tests");
    body.append("</p>\n<table class=\"files\">\n<thead><tr><th>File</th><th>Statements</th>");
    body.append("<th>Branches</th><th>Conditions</th><th>Functions</th>");
    body.append("<th>Missing lines</th></tr></thead>\n<tbody>\n");
    for (FileCoverage file : report.files()) {
      body.append("<tr><th><a href=\"").append(names.get(file.file())).append("\">");
      body.append(HtmlPage.escaped(file.file())).append("</a></th>");
      shares(
          body, file.statements(), file.branchWays(), file.conditionWays(), file.calledFunctions());
      body.append("<td class=\"missing\">").append(file.missing()).append("</td></tr>\n");
    }
    body.append("</tbody>\n<tfoot><tr><th>All</th>");
    shares(
        body,
        report.statements(),
        report.branchWays(),
        report.conditionWays(),
        report.calledFunctions());
    body.append("<td></td></tr></tfoot>\n</table>\n");
    if (!report.trees().isEmpty()) {
      trees(body);
    }
    return HtmlPage.of("Coverage", body.toString());
  }

  private static void shares(StringBuilder body, Share... shares) {
    for (Share share : shares) {
      body.append("<td>").append(HtmlPage.share(share)).append("</td>");
    }
  }

  private void trees(StringBuilder body) {
    body.append("<h2>Nodes of program trees</h2>\n<table class=\"files\">\n");
    body.append("<thead><tr><th>Tree</th><th>Nodes</th><th>Missing nodes</th></tr></thead>\n");
    for (TreeCoverage tree : report.trees()) {
      body.append("<tr><th>").append(HtmlPage.escaped(tree.file())).append("</th>");
      shares(body, tree.share());
      body.append("<td class=\"missing\">");
      String between = "";
      for (NodeCoverage node : tree.nodes()) {
        if (!node.reached()) {
          body.append(between).append(node.number()).append(' ');
          body.append(HtmlPage.escaped(node.label()));
          between = ", ";
        }
      }
      body.append("</td></tr>\n");
    }
    body.append("</table>\n");
  }
}
