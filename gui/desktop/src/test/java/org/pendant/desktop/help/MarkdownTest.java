package org.pendant.desktop.help;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

final class MarkdownTest {
  private static String html(String... lines) {
    return Markdown.html(String.join("\n", lines)).replace("\n", "");
  }

  @Test
  void headingsCanBeLinkedTo() {
    assertEquals("<h2 id=\"the-start-ramp\">The start ramp</h2>", html("## The start ramp"));
  }

  @Test
  void cellsOfTablesStandAtTheTopLeft() {
    String table = html("| a | n |", "| --- | ---: |", "| **b** | 1 |");
    assertTrue(table.contains("<td valign=\"top\" align=\"left\"><strong>b</strong></td>"), table);
    assertTrue(table.contains("<td align=\"right\" valign=\"top\">1</td>"), table);
  }

  @Test
  void barsOfCellsAreWrittenWithABackslash() {
    assertTrue(html("| a \\| b |", "| --- |").contains(">a | b<"));
  }

  @Test
  void codeMeansNothingElse() {
    assertEquals("<p><code>a *b* &lt;c&gt;</code> <em>d</em></p>", html("`a *b* <c>` *d*"));
  }

  @Test
  void tagsInTheTextAreText() {
    assertEquals("<p>the &lt;b&gt; key</p>", html("the <b> key"));
  }

  @Test
  void remarksToTheBuildAreLeftOut() {
    assertEquals("<p>one</p><p>two</p>", html("one", "", "<!-- not run: why -->", "", "two"));
  }

  @Test
  void picturesAreLeftOut() {
    assertEquals("<p>one</p><p>two</p>", html("one", "", "![A picture](a.png)", "", "two"));
  }
}
