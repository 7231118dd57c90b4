package org.pendant.testing.report;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestId;
import org.pendant.testing.report.FailureAttachment.Kind;

class HtmlReportTest {
  private static final Map<TestId, List<FailureAttachment>> ATTACHMENTS =
      Map.of(
          SampleSuite.failed().id(),
          List.of(
              new FailureAttachment("shots/arm 1.png", "The arm \"there\"", Kind.IMAGE),
              new FailureAttachment("a:b#?.rec", "Recording", Kind.LINK)));

  @Test
  void showsARedTestWithMessageSourceStackPicturesAndOutput() throws Exception {
    String page = page(SampleSuite.suite(), ATTACHMENTS);
    int start = page.indexOf("<li class=\"test red\" id=\"red-1\">");
    assertEquals(
        """
        <li class="test red" id="red-1"><details open><summary><span class="mark">✗</span>\
         <span class="name">test_grip[0.05, True]</span> <span class="tag">gripper</span>\
         <span class="tag">slow</span> <span class="status">failed</span>\
         <span class="time">0.100 s</span></summary>
        <pre class="message">width is 0.05 m, expected 0.04 m
        within 0.001 m</pre>
        <p class="place">cell/grip_test.script:2:3</p>
        <pre class="source"><span class="number">1  </span>def close(width):
        <mark><span class="number">2  </span>  assert_near(width, 0.04, 0.001)</mark>
        <span class="caret">     ^</span>
        <span class="number">3  </span>end
        <span class="number">4  </span>
        <span class="number">5  </span>def test_grip(width, closed):
        <span class="number">6  </span>  close(width)
        </pre>
        <h3>Call stack</h3>
        <pre class="stack">in close, cell/grip_test.script:2:3
        in test_grip, cell/grip_test.script:6:3</pre>
        <figure><a href="shots/arm%201.png"><img src="shots/arm%201.png" loading="lazy"\
         alt="The arm &quot;there&quot;"></a>\
        <figcaption>The arm &quot;there&quot;</figcaption></figure>
        <p class="link"><a href="a%3Ab%23%3F.rec">Recording</a></p>
        <h3>Output</h3>
        <pre class="output">closing
        width 0.05</pre>
        </details></li>
        """,
        page.substring(start, page.indexOf("<li class=\"test red\" id=\"red-2\">")));
  }

  @Test
  void opensFilesWithRedTestsAndBeginsWithBrokenOnes() throws Exception {
    String page = page(SampleSuite.suite(), Map.of());
    assertEquals(
        List.of("cell/old_test.script", "cell/pick_test.script", "cell/grip_test.script"),
        Pattern.compile("<details class=\"file [^>]*><summary><span class=\"name\">([^<]*)")
            .matcher(page)
            .results()
            .map(each -> each.group(1))
            .toList());
    assertTrue(
        page.contains(
            "<details class=\"file green\"><summary><span class=\"name\">cell/pick_test.script"));
    assertTrue(
        page.contains(
            "<details class=\"file red\" open><summary><span"
                + " class=\"name\">cell/grip_test.script"));
  }

  @Test
  void beginsWithTheSumAndLinksToRedTests() throws Exception {
    String page = page(SampleSuite.suite(), Map.of());
    assertTrue(
        page.contains(
            """
            <p class="counts">3 passed, 1 failed, 1 error, 1 timed out, 1 skipped, 1 broken file,\
             2 not run</p>
            <p class="seed">3.6 s of robot time, seed 4711</p>
            <svg class="bar" viewBox="0 0 1000 10" preserveAspectRatio="none" aria-hidden="true">\
            <rect class="red" x="0" y="0" width="500" height="10"/>\
            <rect class="skipped" x="500" y="0" width="125" height="10"/>\
            <rect class="green" x="625" y="0" width="375" height="10"/></svg>
            """),
        page);
    assertTrue(
        page.contains(
            "<li><a href=\"#red-2\">cell/grip_test.script test_force</a>"
                + " <span class=\"why\">force_mode: 4 arguments are missing</span></li>"),
        page);
  }

  @Test
  void needsNoScriptNoStyleInsideAndNothingFromElsewhere() throws Exception {
    String page = page(SampleSuite.suite(), ATTACHMENTS);
    assertFalse(page.contains("<script"));
    assertFalse(page.contains("<style"));
    assertFalse(page.contains(" style="));
    assertFalse(page.contains("http:") || page.contains("https:"));
    assertTrue(page.contains("<input type=\"checkbox\" id=\"only-red\">"));
  }

  @Test
  void noTextBecomesMarkup() throws Exception {
    String page =
        page(
            SampleSuite.of(
                SampleSuite.failed(
                    "<script>alert(\"1\")</script>\u0000", List.of("</pre><img src=x>&amp;")),
                SampleSuite.skipped("<b>.script", "test_<i>", "'\"><u>")),
            Map.of());
    assertFalse(page.contains("<script>") || page.contains("<img") || page.contains("<b>"));
    assertFalse(page.contains("<i>") || page.contains("<u>"));
    assertTrue(page.contains("&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt;\\x00</pre>"), page);
    assertTrue(page.contains("&lt;/pre&gt;&lt;img src=x&gt;&amp;amp;"), page);
  }

  @Test
  void refusesAttachmentsOutsideOfItsFolder() {
    for (String each : List.of("", "/etc/passwd", "a/../../b.png", "..", "c:\\b.png")) {
      assertThrows(
          IllegalArgumentException.class, () -> new FailureAttachment(each, "x", Kind.LINK), each);
    }
  }

  @Test
  void noAttachmentIsAnAddressOfItsOwn() {
    assertEquals(
        "javascript%3Aalert(1)".replace("(", "%28").replace(")", "%29"),
        new FailureAttachment("javascript:alert(1)", "x", Kind.LINK).address());
    assertEquals("%C3%A9.png", new FailureAttachment("é.png", "x", Kind.IMAGE).address());
  }

  @Test
  void writesPageAndStyleIntoAFolderAndTheSameBytesAgain(@TempDir Path folder) throws Exception {
    Path report = folder.resolve("build/report");
    HtmlReport html =
        new HtmlReport(SampleSuite.suite(), SampleSuite::source, ATTACHMENTS, Map.of());
    html.write(report);
    byte[] first = Files.readAllBytes(report.resolve("index.html"));
    assertTrue(
        Files.readString(report.resolve("style.css")).contains("prefers-color-scheme: dark"));
    html.write(report);
    assertArrayEquals(first, Files.readAllBytes(report.resolve("index.html")));
    assertEquals(new String(first, StandardCharsets.UTF_8), page(SampleSuite.suite(), ATTACHMENTS));
  }

  @Test
  void boundsOutputAndGrowsWithTheNumberOfResults() throws Exception {
    List<String> output = Collections.nCopies(100_000, "<".repeat(100));
    String page = page(SampleSuite.of(SampleSuite.failed("m", output)), Map.of());
    assertTrue(page.length() < 200_000, page.length() + " characters");
    assertTrue(page.contains("<h3>Output, last 198 of 100000 lines</h3>"), page);
    int small = page(SampleSuite.many(1_000), Map.of()).length();
    int large = page(SampleSuite.many(10_000), Map.of()).length();
    assertTrue(large < 11 * small, small + " and " + large);
  }

  private static String page(SuiteResult suite, Map<TestId, List<FailureAttachment>> attachments)
      throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    new HtmlReport(suite, SampleSuite::source, attachments, Map.of()).writePage(out);
    return out.toString(StandardCharsets.UTF_8);
  }
}
