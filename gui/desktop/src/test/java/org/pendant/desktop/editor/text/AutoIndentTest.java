package org.pendant.desktop.editor.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

final class AutoIndentTest {

  @Test
  void goesDeeperBehindTheHeadOfABlock() {
    assertEquals("  ", AutoIndent.behind("def main():"));
    assertEquals("    ", AutoIndent.behind("  while True:"));
    assertEquals("    ", AutoIndent.behind("  else:   # otherwise"));
  }

  @Test
  void staysBehindOtherLines() {
    assertEquals("  ", AutoIndent.behind("  x = 1"));
    assertEquals("  ", AutoIndent.behind("  # a list:"));
    assertEquals("  ", AutoIndent.behind("  textmsg(\"if:\")"));
  }

  @Test
  void aHashInAStringBeginsNoComment() {
    assertEquals("    ", AutoIndent.behind("  if name == \"#1\":"));
  }

  @Test
  void endGoesBackToTheHeadOfItsBlock() {
    List<String> above =
        List.of("def main():", "  while True:", "    if x:", "      y()", "    end", "    sync()");
    assertEquals("  ", AutoIndent.of("    end", above));
  }

  @Test
  void elseGoesBackToItsIf() {
    List<String> above = List.of("def main():", "  if a:", "    b()", "  elif c:", "    d()");
    assertEquals("  ", AutoIndent.of("    else:", above));
    assertEquals("  ", AutoIndent.of("    elif", above));
  }

  @Test
  void namesThatBeginLikeClosingWordsStay() {
    assertEquals("    ", AutoIndent.of("    ending", List.of("def main():")));
    assertEquals("    ", AutoIndent.of("    end", List.of()));
  }

  @Test
  void linesMoveToTheNextStep() {
    String text = "a\n b\n\n   c\n";
    List<TextSpan> lines = LineIndex.touched(text, new TextSpan(0, text.length()));

    assertEquals("  a\n  b\n\n    c\n", Edit.apply(text, AutoIndent.shifted(lines, text, true)));
    assertEquals("a\nb\n\n  c\n", Edit.apply(text, AutoIndent.shifted(lines, text, false)));
  }
}
