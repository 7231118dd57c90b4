package org.pendant.language.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.DiagnosticFormat;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Script;
import org.pendant.language.syntax.Statement;

@Tag("slow")
class ParserPropertyTest {
  private static final byte[] PIECES =
      "()[]=:;'\"#$\n\r \t+-*/%!<>.,&|{}\\@0e1xp\u00E9end if def else return not run"
          .getBytes(StandardCharsets.ISO_8859_1);

  @Test
  void printedTreesReadBackEqual() {
    for (int seed = 0; seed < 3000; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      List<Statement> statements = new RandomTrees(random).statements(3);
      String text = new ScriptPrinter(random).print(statements);
      Source source = Source.of("seed" + seed, text.getBytes(StandardCharsets.ISO_8859_1));
      ParseResult result = ScriptParser.parseProgram(source);
      String context = "seed " + seed + ":\n" + text;
      assertEquals(List.of(), result.diagnostics(), context);
      assertEquals(
          TreeShape.of(new Script(source, statements, new SourceRange(0, 0))),
          TreeShape.of(result.script()),
          context);
    }
  }

  @Test
  void everyTextIsReadOrRefusedWithoutException() {
    for (int seed = 0; seed < 3000; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      String text = new ScriptPrinter(random).print(new RandomTrees(random).statements(3));
      check(seed, mutated(random, text.getBytes(StandardCharsets.ISO_8859_1)));
    }
  }

  @Test
  void everyPrefixOfProgramIsReadOrRefusedWithoutException() {
    byte[] text =
        """
        def f(a, b=[1, 2]): # head
          $ 1 "label" "noBreak"
          while (not a.b[1] == p[1, 2.5, .3, 4., 5e-3, -6]):
            if x: return "text" elif y: halt else: z = run t() end
          end
        end
        """
            .getBytes(StandardCharsets.UTF_8);
    for (int length = 0; length < text.length; length++) {
      check(length, Arrays.copyOf(text, length));
    }
  }

  private static byte[] mutated(SplittableRandom random, byte[] text) {
    byte[] result = text;
    for (int i = random.nextInt(1, 6); i > 0 && result.length > 0; i--) {
      int at = random.nextInt(result.length);
      int end = Math.min(result.length, at + random.nextInt(4));
      byte[] inserted = new byte[random.nextInt(4)];
      for (int k = 0; k < inserted.length; k++) {
        inserted[k] = PIECES[random.nextInt(PIECES.length)];
      }
      byte[] next = new byte[at + inserted.length + result.length - end];
      System.arraycopy(result, 0, next, 0, at);
      System.arraycopy(inserted, 0, next, at, inserted.length);
      System.arraycopy(result, end, next, at + inserted.length, result.length - end);
      result = next;
    }
    return result;
  }

  private static void check(int seed, byte[] text) {
    Source source = Source.of("mutated", text);
    try {
      ParseResult result = ScriptParser.parseProgram(source);
      for (Diagnostic diagnostic : result.diagnostics()) {
        assertTrue(diagnostic.range().end() <= source.text().length(), diagnostic.toString());
        assertTrue(DiagnosticFormat.format(source, diagnostic).contains(": error: "));
      }
      TreeShape.of(result.script());
    } catch (RuntimeException broken) {
      fail("seed " + seed + ", text:\n" + source.text(), broken);
    }
  }
}
