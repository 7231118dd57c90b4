package org.pendant.desktop.help;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

final class MarkdownTest {
  private static String html(String... lines) {
    return Markdown.html(String.join("\n", lines)).replace("\n", "");
  }

  @Test
  void linesOfAParagraphBelongTogether() {
    assertEquals("<p>one two</p><p>three</p>", html("one", "two", "", "three"));
  }

  @Test
  void headingsCanBeLinkedTo() {
    assertEquals(
        "<a name=\"the-start-ramp\"></a><h2>The start ramp</h2>", html("## The start ramp"));
  }

  @Test
  void tablesHaveARowForEachLineAndNoneForTheRule() {
    assertEquals(
        "<table><tr><td valign=\"top\">a</td><td valign=\"top\"><b>b</b></td></tr></table>",
        html("| a | **b** |", "| --- | --- |"));
  }

  @Test
  void barsOfCellsAreWrittenWithABackslash() {
    assertTrue(html("| a \\| b |").contains(">a | b<"));
  }

  @Test
  void itemsMayHaveSeveralLines() {
    assertEquals("<ul><li>one more</li><li>two</li></ul>", html("- one", "  more", "- two"));
  }

  @Test
  void codeMeansNothingElse() {
    assertEquals("<p><code>a *b* &lt;c&gt;</code> <i>d</i></p>", html("`a *b* <c>` *d*"));
  }

  @Test
  void blocksOfCodeKeepTheirLines() {
    assertEquals("<pre>def f():\n  x = 1\n</pre>\n", Markdown.html("```\ndef f():\n  x = 1\n```"));
  }

  @Test
  void linksLeadSomewhere() {
    assertEquals("<p>see <a href=\"a.md#b\">a</a></p>", html("see [a](a.md#b)"));
  }
}
