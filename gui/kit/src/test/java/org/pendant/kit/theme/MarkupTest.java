package org.pendant.kit.theme;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

final class MarkupTest {
  @Test
  void whatLooksLikeMarkupIsShownAsItIs() {
    assertEquals("&lt;b&gt;a &amp; b", Markup.escaped("<b>a & b"));
  }

  @Test
  void aToolTipKeepsLinesAndIsCutWhereItIsVeryLong() {
    assertTrue(Markup.toolTip("<a>\nb").endsWith(">&lt;a&gt;<br>b"));
    assertTrue(Markup.toolTip("x".repeat(5000)).length() < 2100);
  }
}
