package org.pendant.language.source;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class DiagnosticFormatTest {

  @Test
  void showsPlaceMessageLineAndCaret() {
    Source source = Source.of("a.script", "def f():\n  foo(1)\nend\n");
    assertEquals(
        """
        a.script:2:3: error: `foo` is not known
          foo(1)
          ^~~\
        """
            .replace("\n", System.lineSeparator()),
        DiagnosticFormat.format(
            source, Diagnostic.error("x", new SourceRange(11, 14), "`foo` is not known", "")));
  }

  @Test
  void showsWarnings() {
    Source source = Source.of("a.script", "x = 1");
    assertTrue(
        DiagnosticFormat.format(source, Diagnostic.warning("x", new SourceRange(0, 1), "odd"))
            .startsWith("a.script:1:1: warning: odd"));
  }

  @Test
  void keepsTabsSoThatTheCaretLinesUp() {
    Source source = Source.of("a", "\tx\t= y");
    assertEquals("\t \t  ^", caretLine(source, new SourceRange(5, 6)));
  }

  @Test
  void decodesUtf8AndCountsCharactersForTheCaret() {
    Source source = Source.of("a", "s = \"\u00E9\uAC00\" + y");
    int y = source.text().indexOf('y');
    String text =
        DiagnosticFormat.format(
            source, Diagnostic.error("x", new SourceRange(y, y + 1), "bad `\u00C3\u00A9`", ""));
    assertTrue(text.contains("s = \"\u00E9\uAC00\" + y"), text);
    assertTrue(text.contains("bad `\u00E9`"), text);
    assertEquals(" ".repeat(11) + "^", text.lines().toList().getLast());
  }

  @Test
  void showsOnlyPartOfLongLine() {
    Source source = Source.of("a", "x = " + "1 + ".repeat(1000) + "y");
    int end = source.text().length();
    String text =
        DiagnosticFormat.format(
            source, Diagnostic.error("x", new SourceRange(end - 1, end), "m", ""));
    assertTrue(text.lines().allMatch(line -> line.length() <= 200), text);
    assertTrue(text.lines().toList().get(1).endsWith("y"));
  }

  @Test
  void keepsControlBytesFromTheTerminal() {
    Source source = Source.of("a\u001B[1m\n\u009B", "x = \u001B[2J \u0007");
    String text =
        DiagnosticFormat.format(source, Diagnostic.error("x", new SourceRange(4, 5), "m", ""));
    assertFalse(text.contains("\u001B"));
    assertFalse(text.contains("\u0007"));
    assertFalse(text.contains("\u009B"));
    assertEquals(3, text.lines().count(), text);
  }

  @Test
  void pointsBehindTheLastByteAtTheEndOfTheText() {
    Source source = Source.of("a", "f(");
    assertEquals("  ^", caretLine(source, new SourceRange(2, 2)));
    assertEquals("^", caretLine(Source.of("a", ""), new SourceRange(0, 0)));
  }

  @Test
  void underlinesOnlyTheFirstLineOfLongFault() {
    assertEquals("^~~~~~~~", caretLine(Source.of("a", "def f():\nend"), new SourceRange(0, 12)));
  }

  private static String caretLine(Source source, SourceRange range) {
    return DiagnosticFormat.format(source, Diagnostic.error("x", range, "m", ""))
        .lines()
        .toList()
        .getLast();
  }
}
