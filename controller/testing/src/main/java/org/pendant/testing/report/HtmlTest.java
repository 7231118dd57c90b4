package org.pendant.testing.report;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestPlace;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;

/** HTML test: one test in the tree of an {@link HtmlReport}. */
final class HtmlTest {
  private static final int OUTPUT_LINES = 200;
  private static final int OUTPUT_CHARACTERS = 20_000;

  /** Lines of the source above and below the one that failed. */
  private static final int MARGIN_LINES = 4;

  private final HtmlText html;
  private final SourceExcerpts excerpts;

  HtmlTest(HtmlText html, SourceExcerpts excerpts) {
    this.html = html;
    this.excerpts = excerpts;
  }

  /**
   * Writes it as an item of a list.
   *
   * @param redNumber which of the red tests it is, from 1; 0 if it is none
   */
  void write(
      TestResult test,
      int redNumber,
      List<FailureAttachment> attachments,
      Optional<FailurePlot> plot)
      throws IOException {
    if (!test.status().red()) {
      boolean skipped = test.status() == TestStatus.SKIPPED;
      html.raw("<li class=\"test " + (skipped ? "skipped" : "green") + "\">");
      title(test);
      html.raw("</li>\n");
      return;
    }
    html.raw("<li class=\"test red\" id=\"red-" + redNumber + "\"><details open><summary>");
    title(test);
    html.raw("</summary>\n");
    html.element("pre", "message", String.join("\n", ReportText.message(test))).raw("\n");
    source(test.failure().flatMap(TestFailure::place));
    stack(FailureText.calls(test, ReportLanguage.ENGLISH));
    attachments(attachments, FailureAttachment.Kind.IMAGE);
    if (plot.isPresent() && plot.get().tells()) {
      new PlotMarkup(html, plot.get()).write();
    }
    attachments(attachments, FailureAttachment.Kind.LINK);
    output(ReportText.output(test, OUTPUT_LINES, OUTPUT_CHARACTERS));
    html.raw("</details></li>\n");
  }

  private void title(TestResult test) throws IOException {
    String mark =
        switch (test.status()) {
          case PASSED -> "✓";
          case SKIPPED -> "○";
          case FAILED, ERROR, TIMED_OUT -> "✗";
        };
    html.element("span", "mark", mark).raw(" ");
    html.element("span", "name", ReportText.line(test.id().name())).raw(" ");
    for (String each : test.tags()) {
      html.element("span", "tag", ReportText.line(each)).raw(" ");
    }
    html.element("span", "status", ReportText.status(test.status()));
    if (test.status() == TestStatus.SKIPPED) {
      html.raw(" ").element("span", "why", ReportText.line(test.skipped()));
    } else {
      html.raw(" ").element("span", "time", ReportText.duration(test.robotTimeS()));
    }
  }

  private void source(Optional<TestPlace> place) throws IOException {
    if (place.isEmpty()) {
      return;
    }
    html.element("p", "place", FailureText.text(place.get())).raw("\n");
    List<SourceExcerpts.Line> lines = excerpts.around(place.get(), MARGIN_LINES);
    if (lines.isEmpty()) {
      return;
    }
    int width = Integer.toString(lines.getLast().number()).length();
    html.raw("<pre class=\"source\">");
    for (SourceExcerpts.Line each : lines) {
      String number = " ".repeat(width - Integer.toString(each.number()).length()) + each.number();
      if (each.caret().isPresent()) {
        html.raw("<mark>").element("span", "number", number + "  ").text(each.text());
        html.raw("</mark>\n");
        if (!each.caret().get().isEmpty()) {
          html.element("span", "caret", " ".repeat(width + 2) + each.caret().get()).raw("\n");
        }
      } else {
        html.element("span", "number", number + "  ").text(each.text()).raw("\n");
      }
    }
    html.raw("</pre>\n");
  }

  private void stack(List<String> calls) throws IOException {
    if (calls.isEmpty()) {
      return;
    }
    html.raw("<h3>Call stack</h3>\n");
    html.element("pre", "stack", String.join("\n", calls)).raw("\n");
  }

  private void attachments(List<FailureAttachment> attachments, FailureAttachment.Kind kind)
      throws IOException {
    for (FailureAttachment each : attachments) {
      if (each.kind() == kind) {
        attachment(each);
      }
    }
  }

  private void attachment(FailureAttachment attachment) throws IOException {
    String address = attachment.address();
    String title = ReportText.line(attachment.title());
    switch (attachment.kind()) {
      case IMAGE -> {
        html.raw("<figure><a href=\"" + address + "\"><img src=\"" + address);
        html.raw("\" loading=\"lazy\" alt=\"").text(title).raw("\"></a><figcaption>");
        html.text(title).raw("</figcaption></figure>\n");
      }
      case LINK ->
          html.raw("<p class=\"link\"><a href=\"" + address + "\">").text(title).raw("</a></p>\n");
    }
  }

  private void output(ReportText.Output output) throws IOException {
    if (output.lines().isEmpty()) {
      return;
    }
    html.raw("<h3>O").text(output.title().substring(1)).raw("</h3>");
    html.raw("\n").element("pre", "output", String.join("\n", output.lines())).raw("\n");
  }
}
