package org.pendant.command.comparison;

import java.util.List;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.recording.compare.Difference;
import org.pendant.recording.compare.RunComparison;

/** Comparison as a page: HTML that needs no other file, with tables and charts. */
public final class ComparisonPage {
  private static final String HEAD =
      """
      <!DOCTYPE html>
      <html lang="en">
      <head>
      <meta charset="utf-8">
      <meta http-equiv="Content-Security-Policy"
        content="default-src 'none'; style-src 'unsafe-inline'">
      <title>TITLE</title>
      <style>
      body { font-family: sans-serif; margin: 2em; max-width: 62em; color: #222; }
      table { border-collapse: collapse; margin: 1em 0; }
      th, td { padding: 0.15em 0.8em; text-align: right; border-bottom: 1px solid #ddd; }
      th:first-child, td:first-child { text-align: left; }
      svg { max-width: 100%; height: auto; margin: 0.5em 0; }
      .over { color: #b00020; font-weight: bold; }
      </style>
      </head>
      <body>
      """;

  private ComparisonPage() {}

  /** The text of the file. */
  public static String of(ComparedRun run) {
    RunComparison comparison = run.comparison();
    StringBuilder page = new StringBuilder();
    String title = MarkupText.of(run.recording() + " and " + run.program());
    page.append(HEAD.replace("TITLE", title));
    page.append("<h1>").append(title).append("</h1>\n<p>Arm ").append(MarkupText.of(run.robot()));
    page.append(", payload ").append(MarkupText.of(run.payload())).append(", ");
    page.append(comparison.recorded().rows()).append(" samples.</p>\n<ul>\n");
    comparison
        .notes()
        .forEach(note -> page.append("<li>").append(MarkupText.of(note)).append("</li>\n"));
    page.append("</ul>\n");
    if (!run.limits().isEmpty()) {
      page.append("<h2>Limits</h2>\n<table>\n");
      row(page, "th", List.of("name", "limit", "difference"));
      run.limits().forEach(limit -> limit(page, limit));
      page.append("</table>\n");
    }
    page.append("<h2>Figures</h2>\n<table>\n");
    row(page, "th", List.of("name", "unit", "recorded", "Pendant", "error"));
    for (Difference each : comparison.differences()) {
      if (each instanceof Difference.Figure) {
        row(page, "td", cells(each));
      }
    }
    page.append("</table>\n<h2>Pendant less recording, at all samples</h2>\n<table>\n");
    row(page, "th", List.of("name", "unit", "from", "to", "mean", "rms", "largest"));
    for (Difference each : comparison.differences()) {
      if (each instanceof Difference.Residual) {
        row(page, "td", cells(each));
      }
    }
    page.append("</table>\n<h2>Charts</h2>\n");
    for (StateQuantity each : run.charts()) {
      page.append(ChartSvg.of(comparison, each));
    }
    return page.append("</body>\n</html>\n").toString();
  }

  private static void limit(StringBuilder page, ComparedRun.Limit limit) {
    page.append(limit.kept() ? "<tr>" : "<tr class=\"over\">");
    for (String cell :
        List.of(limit.name(), Difference.text(limit.most()), Difference.text(limit.size()))) {
      page.append("<td>").append(MarkupText.of(cell)).append("</td>");
    }
    page.append("</tr>\n");
  }

  /** The cells of a row about a difference: its name, its unit, its numbers. */
  public static List<String> cells(Difference difference) {
    return switch (difference) {
      case Difference.Figure each ->
          List.of(
              each.name(),
              each.unit(),
              Difference.text(each.recorded()),
              Difference.text(each.pendant()),
              Difference.text(each.error()));
      case Difference.Residual each ->
          List.of(
              each.name(),
              each.unit(),
              Difference.text(each.least()),
              Difference.text(each.most()),
              Difference.text(each.mean()),
              Difference.text(each.rms()),
              Difference.text(each.largest()));
    };
  }

  private static void row(StringBuilder page, String tag, List<String> cells) {
    page.append("<tr>");
    for (String cell : cells) {
      page.append('<').append(tag).append('>').append(MarkupText.of(cell));
      page.append("</").append(tag).append('>');
    }
    page.append("</tr>\n");
  }
}
