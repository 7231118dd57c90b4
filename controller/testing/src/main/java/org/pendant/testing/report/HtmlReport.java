package org.pendant.testing.report;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.language.source.Source;
import org.pendant.testing.BrokenTestFile;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestId;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;

/**
 * HTML report: a page with the tree of files and tests, red ones with everything that is known of
 * them. It needs nothing from elsewhere and no script, so it works from a disk and as an artefact
 * of a CI system. The style is a file of its own: Jenkins lets no page that it serves have one
 * inside. The same results are the same bytes.
 */
public final class HtmlReport {
  private static final String STYLE = "style.css";

  private static final String HEAD =
      """
      <!DOCTYPE html>
      <html lang="en">
      <head>
      <meta charset="utf-8">
      <meta name="viewport" content="width=device-width, initial-scale=1">
      <meta name="color-scheme" content="light dark">
      <meta http-equiv="Content-Security-Policy"
        content="script-src 'none'; object-src 'none'; base-uri 'none'; form-action 'none'">
      <title>Tests: COUNTS</title>
      <link rel="stylesheet" href="style.css">
      </head>
      <body>
      """;

  private final SuiteResult result;
  private final Function<String, Optional<Source>> sources;
  private final Map<TestId, List<FailureAttachment>> attachments;
  private final Map<TestId, FailurePlot> plots;

  /**
   * A report of one run.
   *
   * @param sources the text of a file by its name in places, if it can be had
   * @param attachments files that are in the folder of the report or will be
   * @param plots of red tests
   */
  public HtmlReport(
      SuiteResult result,
      Function<String, Optional<Source>> sources,
      Map<TestId, List<FailureAttachment>> attachments,
      Map<TestId, FailurePlot> plots) {
    this.result = result;
    this.sources = sources;
    this.attachments = Map.copyOf(attachments);
    this.plots = Map.copyOf(plots);
  }

  /**
   * Writes {@code index.html} and its style into a folder, which is made; replaces those that are
   * there and leaves other files alone.
   */
  public void write(Path folder) throws IOException {
    try (InputStream style = HtmlReport.class.getResourceAsStream(STYLE)) {
      if (style == null) {
        throw new IllegalStateException("no " + STYLE + " beside HtmlReport");
      }
      AtomicFile.write(folder.resolve(STYLE), style.readAllBytes());
    }
    AtomicFile.write(folder.resolve("index.html"), this::writePage);
  }

  /** Writes the text of {@code index.html}, as UTF-8, and leaves {@code out} open. */
  void writePage(OutputStream out) throws IOException {
    Writer writer = new BufferedWriter(new OutputStreamWriter(out, StandardCharsets.UTF_8));
    HtmlText html = new HtmlText(writer);
    IdentityHashMap<TestResult, Integer> redNumbers = new IdentityHashMap<>();
    for (TestResult each : result.results()) {
      if (each.status().red()) {
        redNumbers.put(each, redNumbers.size() + 1);
      }
    }
    head(html);
    redOnes(html, redNumbers);
    html.raw("<input type=\"checkbox\" id=\"only-red\">");
    html.raw("<label for=\"only-red\">Only red ones</label>\n<main>\n");
    for (BrokenTestFile each : result.broken()) {
      broken(html, each);
    }
    HtmlTest test = new HtmlTest(html, new SourceExcerpts(sources));
    for (Map.Entry<String, List<TestResult>> each : files().entrySet()) {
      beginFile(html, each.getKey(), each.getValue());
      warnings(html, result.warningsOf(each.getKey()));
      html.raw("<ul>\n");
      for (TestResult one : each.getValue()) {
        test.write(
            one,
            redNumbers.getOrDefault(one, 0),
            attachments.getOrDefault(one.id(), List.of()),
            Optional.ofNullable(plots.get(one.id())));
      }
      html.raw("</ul>\n</details>\n");
    }
    html.raw("</main>\n</body>\n</html>\n");
    writer.flush();
  }

  private Map<String, List<TestResult>> files() {
    Map<String, List<TestResult>> files = new LinkedHashMap<>();
    for (TestResult each : result.results()) {
      files.computeIfAbsent(each.id().file(), f -> new ArrayList<>()).add(each);
    }
    return files;
  }

  private void head(HtmlText html) throws IOException {
    String counts = ConsoleSummary.counts(result, ReportLanguage.ENGLISH);
    html.raw(HEAD.replace("COUNTS", counts));
    html.raw("<header class=\"" + (result.red() ? "red" : "green") + "\">\n<h1>Tests</h1>\n");
    html.element("p", "counts", counts).raw("\n");
    String seed = ConsoleSummary.robotTime(result) + ", seed " + result.seed();
    html.element("p", "seed", seed).raw("\n");
    bar(html);
    html.raw("</header>\n");
  }

  /** How many passed, are red and were skipped, as a bar. */
  private void bar(HtmlText html) throws IOException {
    long skipped = result.count(TestStatus.SKIPPED);
    long passed = result.count(TestStatus.PASSED);
    long red = result.results().size() - skipped - passed + result.broken().size();
    long all = Math.max(1, passed + red + skipped);
    html.raw("<svg class=\"bar\" viewBox=\"0 0 1000 10\" preserveAspectRatio=\"none\"");
    html.raw(" aria-hidden=\"true\">");
    long from = 0;
    from += part(html, "red", from, red, all);
    from += part(html, "skipped", from, skipped, all);
    part(html, "green", from, passed, all);
    html.raw("</svg>\n");
  }

  private static long part(HtmlText html, String className, long from, long count, long all)
      throws IOException {
    long x = from * 1000 / all;
    long width = (from + count) * 1000 / all - x;
    if (width > 0) {
      html.raw("<rect class=\"" + className + "\" x=\"" + x + "\" y=\"0\" width=\"" + width);
      html.raw("\" height=\"10\"/>");
    }
    return count;
  }

  private void redOnes(HtmlText html, IdentityHashMap<TestResult, Integer> redNumbers)
      throws IOException {
    if (redNumbers.isEmpty()) {
      return;
    }
    html.raw("<nav>\n<h2>Red tests</h2>\n<ol>\n");
    for (TestResult each : result.results()) {
      if (each.status().red()) {
        html.raw("<li><a href=\"#red-" + redNumbers.get(each) + "\">");
        html.text(ConsoleSummary.name(each.id())).raw("</a> ");
        html.element("span", "why", ReportText.message(each).getFirst()).raw("</li>\n");
      }
    }
    html.raw("</ol>\n</nav>\n");
  }

  private void beginFile(HtmlText html, String file, List<TestResult> results) throws IOException {
    boolean red = results.stream().anyMatch(each -> each.status().red());
    html.raw("<details class=\"file " + (red ? "red\" open>" : "green\">") + "<summary>");
    html.element("span", "name", ReportText.line(file)).raw(" ");
    html.element("span", "counts", ConsoleSummary.counts(results, ReportLanguage.ENGLISH))
        .raw("</summary>\n");
  }

  private static void warnings(HtmlText html, List<String> warnings) throws IOException {
    if (!warnings.isEmpty()) {
      String lines = ReportText.warnings(warnings).collect(Collectors.joining("\n"));
      html.element("pre", "warnings", lines).raw("\n");
    }
  }

  private static void broken(HtmlText html, BrokenTestFile file) throws IOException {
    html.raw("<details class=\"file red\" open><summary>");
    html.element("span", "name", ReportText.line(file.file())).raw(" ");
    html.element("span", "counts", "no test of it could run").raw("</summary>\n");
    html.element("pre", "output", String.join("\n", ReportText.problems(file)));
    html.raw("\n</details>\n");
  }
}
