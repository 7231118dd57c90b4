package org.pendant.language.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.Source;
import org.pendant.language.syntax.Statement;

/** A text that is read with the help of an earlier version is read as if there were none. */
final class ReadAgainTest {
  private static final int TEXTS = 30;
  private static final int EDITS = 12;

  @Test
  void anEditedTextIsReadAsOneThatIsNew() {
    for (int seed = 0; seed < TEXTS; seed++) {
      RandomEdits edits = new RandomEdits(new SplittableRandom(seed));
      ReadText read = ScriptParser.read(edits.program("seed" + seed));
      for (int i = 0; i < EDITS; i++) {
        Source before = read.result().script().source();
        Source source = edits.edited(before);
        String about = "seed " + seed + " edit " + i + "\n" + before.text() + "\n=>\n";
        read = ScriptParser.read(source, read);
        ReadText whole = ScriptParser.read(source);
        assertEquals(whole.lexemes(), read.lexemes(), about + source.text());
        assertEquals(shown(whole), shown(read), about + source.text());
        assertEquals(
            whole.result().script().statements(),
            read.result().script().statements(),
            about + source.text());
        assertEquals(
            whole.result().diagnostics(), read.result().diagnostics(), about + source.text());
      }
    }
  }

  @Test
  void whatStandsBeforeAnEditIsTheSameTreeAndWhatStandsBehindIsMoved() {
    String text =
        "def a():\n  x = 1\nend\ndef b():\n  y = 2\n  z = 3\nend\ndef c():\n  u = 4\nend\n";
    ReadText before = ScriptParser.read(Source.of("s", text));
    ReadText after = ScriptParser.read(Source.of("s", text.replace("y = 2", "why = 2")), before);
    assertSame(statement(before, 0), statement(after, 0));
    assertNotEquals(statement(before, 1), statement(after, 1));
    assertEquals(statement(before, 2).range().start() + 2, statement(after, 2).range().start());
  }

  @Test
  void aStatementWithAnErrorIsReadAgain() {
    Source broken = Source.of("s", "a = 1\nb = = 2\nc = 3\n");
    ReadText before = ScriptParser.read(broken);
    ReadText after = ScriptParser.read(Source.of("s", "a = 1\nb = = 2\nc = 31\n"), before);
    assertEquals(before.result().diagnostics(), after.result().diagnostics());
    assertSame(statement(before, 0), statement(after, 0));
    ReadText mended = ScriptParser.read(Source.of("s", "a = 1\nb = 2\nc = 31\n"), after);
    assertTrue(mended.result().ok());
    assertEquals(3, mended.result().script().statements().size());
  }

  private static Statement statement(ReadText read, int index) {
    return read.result().script().statements().get(index);
  }

  private static List<String> shown(ReadText read) {
    Source source = read.result().script().source();
    return read.tokens().stream()
        .flatMap(table -> table.tokens(source, new UrScriptLexer(new ByteStream(source))).stream())
        .map(
            token ->
                token.getType()
                    + " "
                    + token.range()
                    + " "
                    + token.getLine()
                    + " "
                    + token.depth()
                    + token.firstOnLine())
        .toList();
  }
}
