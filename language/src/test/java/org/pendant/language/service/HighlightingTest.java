package org.pendant.language.service;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.Source;

final class HighlightingTest {

  @Test
  void everyClassOfWordHasItsStyle() {
    assertEquals(
        "def/KEYWORD f/FUNCTION a/PARAMETER =/OPERATOR 1/NUMBER"
            + " movej/BUILTIN a/PARAMETER v/PARAMETER =/OPERATOR 2.5/NUMBER"
            + " x/VARIABLE =/OPERATOR y/UNKNOWN and/KEYWORD \"s\"/STRING # c/COMMENT end/KEYWORD"
            + " $ 1 \"l\"/LABEL f/FUNCTION g/UNKNOWN",
        styles("def f(a=1):\n movej(a, v=2.5)\n x = y and \"s\" # c\nend\n$ 1 \"l\"\nf()\ng()\n"));
  }

  @Test
  void membersMethodsAndPosesAreToldApart() {
    assertEquals(
        "l/VARIABLE =/OPERATOR p/KEYWORD 1/NUMBER l/VARIABLE append/BUILTIN 2/NUMBER"
            + " x/VARIABLE =/OPERATOR l/VARIABLE end/MEMBER",
        styles("l = p[1]\nl.append(2)\nx = l.end\n"));
  }

  @Test
  void parametersEndWithTheirFunction() {
    assertEquals("UNKNOWN", styleOf("def f(a):\n if 1:\n end\nend\nx = |a\n"));
    assertEquals("PARAMETER", styleOf("def f(a):\n if 1:\n x = |a\n"));
    assertEquals("UNKNOWN", styleOf("def f(a):\n def g():\n x = |a\n"));
  }

  @Test
  void variablesAreKnownWhereverTheyAreAssigned() {
    assertEquals("VARIABLE", styleOf("x = |later\nglobal later = 1\n"));
  }

  @Test
  void brokenTextsKeepTheirColours() {
    assertEquals("def/KEYWORD", styles("def"));
    assertEquals("x/VARIABLE =/OPERATOR \"open/STRING", styles("x = \"open"));
    assertEquals("x/UNKNOWN &&/UNKNOWN ;/UNKNOWN", styles("x && ;"));
    assertEquals("end/KEYWORD end/KEYWORD", styles("end end )"));
  }

  @Test
  void stretchesNeverOverlapWhateverTheTextIs() {
    byte[] pieces =
        "()[]=:;'\"#$\n\r \t+-*/%!<>.,&|{}\\@0e1xp\u00E9end if def else return not run"
            .getBytes(StandardCharsets.ISO_8859_1);
    for (int seed = 0; seed < 2000; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      byte[] text = new byte[random.nextInt(60)];
      for (int i = 0; i < text.length; i++) {
        text[i] = pieces[random.nextInt(pieces.length)];
      }
      Source source = Source.of("random", text);
      int end = 0;
      for (HighlightToken token : Highlighting.of(source, new EditorCatalogue())) {
        assertTrue(token.start() >= end && token.end() > token.start(), "seed " + seed);
        end = token.end();
      }
      assertTrue(end <= text.length, "seed " + seed);
    }
  }

  private static String styles(String text) {
    Source source = Source.of("test.script", text);
    return Highlighting.of(source, new EditorCatalogue()).stream()
        .map(token -> text.substring(token.start(), token.end()) + "/" + token.style())
        .collect(Collectors.joining(" "));
  }

  private static String styleOf(String marked) {
    Marked place = Marked.of(marked);
    List<HighlightToken> tokens = place.analysis().highlighting();
    return tokens.stream()
        .filter(token -> token.start() == place.caret())
        .map(token -> token.style().toString())
        .findFirst()
        .orElseThrow();
  }
}
