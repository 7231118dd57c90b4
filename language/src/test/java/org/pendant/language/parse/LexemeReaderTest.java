package org.pendant.language.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import org.antlr.v4.runtime.Token;
import org.junit.jupiter.api.Test;
import org.pendant.language.parse.Lexeme.Kind;
import org.pendant.language.source.Source;

final class LexemeReaderTest {

  @Test
  void commentsAreLexemesToo() {
    assertEquals(
        "NAME:a ASSIGN:= NUMBER:1 COMMENT:# one COMMENT:# two END:end",
        read("a = 1 # one\n  # two\r\nend"));
  }

  @Test
  void aNumberSignInAStringOrLabelBeginsNoComment() {
    assertEquals("LABEL:$ 1 \"#\" NAME:f OPEN:( STRING:\"#\" CLOSE:)", read("$ 1 \"#\"\nf(\"#\")"));
  }

  @Test
  void reservedWordsBehindADotAreNames() {
    assertEquals("NAME:t DOT:. NAME:end", read("t.end"));
    assertEquals("NAME:t DOT:. END:end", read("t.\nend"));
  }

  @Test
  void familiesOfWordsAreToldApart() {
    assertEquals(
        "OPENER:def ALTERNATIVE:elif END:end STATEMENT_WORD:run STATEMENT_WORD:local"
            + " OPERATOR_WORD:not CONSTANT:None FOREIGN:&& FOREIGN:\"open",
        read("def elif end run local not None && \"open"));
  }

  @Test
  void theFirstOnEachLineIsMarked() {
    assertEquals(
        List.of(true, false, true, true),
        LexemeReader.lexemes(Source.of("test", "\na b\n\n  # d\ne")).stream()
            .map(Lexeme::firstOnLine)
            .toList());
  }

  @Test
  void aByteOrderMarkIsSkipped() {
    assertEquals("NAME:a", read("\uFEFFa"));
  }

  @Test
  void lexemesAreTheParsersTokensAndCommentsWithBlanksBetween() {
    for (int seed = 0; seed < 2000; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      String text = new ScriptPrinter(random).print(new RandomTrees(random).statements(3));
      Source source = Source.of("seed", text.getBytes(StandardCharsets.ISO_8859_1));
      List<Lexeme> lexemes = LexemeReader.lexemes(source);
      assertEquals(lexemes, ScriptParser.read(source).lexemes(), "seed " + seed);
      int end = 0;
      for (Lexeme lexeme : lexemes) {
        assertTrue(source.text().substring(end, lexeme.start()).isBlank(), "seed " + seed);
        end = lexeme.end();
      }
      assertEquals(
          new TokenPass(source, false)
              .read().stream()
                  .filter(token -> !token.is(Token.EOF) && !token.is(UrScriptLexer.LABEL))
                  .map(ScriptToken::range)
                  .toList(),
          lexemes.stream()
              .filter(lexeme -> lexeme.kind() != Kind.COMMENT && lexeme.kind() != Kind.LABEL)
              .map(Lexeme::range)
              .toList(),
          "seed " + seed);
    }
  }

  @Test
  void aTextThatTheParserGivesUpHasAllItsLexemes() {
    for (String text :
        List.of(
            "x = " + "(".repeat(300) + "1 # deep",
            "\uFEFFa = 1.end # b",
            "f(a,\n$ 3 \"x\"\n  b) ;")) {
      Source source = Source.of("test", text);
      assertEquals(LexemeReader.lexemes(source), ScriptParser.read(source).lexemes());
    }
  }

  private static String read(String text) {
    Source source = Source.of("test", text);
    return LexemeReader.lexemes(source).stream()
        .map(lexeme -> lexeme.kind() + ":" + source.text(lexeme.range()))
        .collect(Collectors.joining(" "));
  }
}
