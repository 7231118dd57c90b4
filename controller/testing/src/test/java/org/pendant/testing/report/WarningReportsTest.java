package org.pendant.testing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.testing.FileWarnings;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.report.ConsoleStyle.Detail;
import org.pendant.testing.report.ConsoleStyle.Feature;

/** What the checker warns of in files of tests, in the reports. */
class WarningReportsTest {
  private static final String WARNING =
      SampleSuite.PICK + ":6:13: warning: name \"<b>\" is not defined";
  private static final SuiteResult SUITE =
      new SuiteResult(
          List.of(SampleSuite.passed(SampleSuite.PICK, "test_pick", 1.25)),
          List.of(),
          List.of(new FileWarnings(SampleSuite.PICK, List.of(WARNING))),
          1,
          0,
          0.5);

  private static String console(Detail detail) {
    StringBuilder out = new StringBuilder();
    ConsoleReport report =
        new ConsoleReport(
            new ConsoleStyle(detail, EnumSet.noneOf(Feature.class)),
            _ -> Optional.empty(),
            out::append);
    report.begin(SUITE.results().stream().map(each -> each.id()).toList());
    SUITE.results().forEach(report::finished);
    report.end(SUITE);
    return out.toString();
  }

  @Test
  void theConsoleTellsThemOnceBeforeTheSum() {
    assertEquals(
        """
        ✓ cell/pick_test.script: 1 passed in 1.3 s

        cell/pick_test.script:6:13: warning: name "<b>" is not defined

        1 passed in 1.3 s of robot time (seed 1)
        """,
        console(Detail.NORMAL));
    assertFalse(console(Detail.QUIET).contains("warning"));
  }

  @Test
  void pagesTellThemAtTheirFileAsText() throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    new HtmlReport(SUITE, _ -> Optional.empty(), Map.of(), Map.of()).writePage(out);
    String page = out.toString(StandardCharsets.UTF_8);
    assertTrue(
        page.contains(
            "<pre class=\"warnings\">cell/pick_test.script:6:13: warning: name"
                + " &quot;&lt;b&gt;&quot; is not defined</pre>\n<ul>"),
        page);
  }

  @Test
  void junitHasThemAsErrorOutputOfTheFile() throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    JunitReport.write(SUITE, _ -> Optional.empty(), out);
    assertTrue(
        out.toString(StandardCharsets.UTF_8)
            .contains("<system-err>cell/pick_test.script:6:13: warning: name \"&lt;b&gt;\""),
        out::toString);
  }

  @Test
  void githubMarksTheirLinesWithoutAnError() {
    assertEquals(
        List.of(
            "::warning file=cell/pick_test.script,line=6,col=13,title=warning"
                + "::name \"<b>\" is not defined"),
        GithubAnnotations.lines(SUITE));
  }

  @Test
  void tapHasTestsAlone() throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    TapReport.write(SUITE, out);
    assertFalse(out.toString(StandardCharsets.UTF_8).contains("warning"));
  }
}
