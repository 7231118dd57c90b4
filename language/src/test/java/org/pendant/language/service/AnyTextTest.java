package org.pendant.language.service;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.language.parse.RandomTrees;
import org.pendant.language.parse.ScriptPrinter;
import org.pendant.language.source.Source;

/** No text and no offset makes a question fail, and what is renamed can be renamed back. */
@Tag("slow")
final class AnyTextTest {
  private static final String PROGRAM =
      """
      # A comment
      def place(target, height=[1, 2]): # head
        $ 1 "label" "noBreak"
        local part = struct(mass = 1.5, name = "x")
        while (not part.mass == p[1, 2.5, .3, 4., 5e-3, -6][0]):
          if height: return "text" elif target: halt else: z = run watch() end
          thread watch():
            global seen = part.length()
          end
        end
      end
      place(1, height=2)
      """;

  @Test
  void everyBeginningOfAProgramIsAnsweredAtItsEnd() {
    for (int length = 0; length <= PROGRAM.length(); length++) {
      answerEverything(Source.of("cut", PROGRAM.substring(0, length)), length);
    }
  }

  @Test
  void everyProgramWithAPieceMissingIsAnswered() {
    for (int seed = 0; seed < 1000; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      int from = random.nextInt(PROGRAM.length());
      int to = Math.min(PROGRAM.length(), from + random.nextInt(30));
      String text = PROGRAM.substring(0, from) + PROGRAM.substring(to);
      answerEverything(Source.of("seed" + seed, text), random.nextInt(text.length() + 1));
    }
  }

  @Test
  void randomBytesAreAnswered() {
    byte[] pieces =
        "()[]=:;'\"#$\n\r \t+-*/%!<>.,&|{}\\@0e1xp\u00E9end if def else return not run"
            .getBytes(StandardCharsets.ISO_8859_1);
    for (int seed = 0; seed < 1000; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      byte[] text = new byte[random.nextInt(60)];
      for (int i = 0; i < text.length; i++) {
        text[i] = pieces[random.nextInt(pieces.length)];
      }
      answerEverything(Source.of("seed" + seed, text), random.nextInt(text.length + 1));
    }
  }

  @Test
  void everyRenamingCanBeTakenBack() {
    int renamed = 0;
    for (int seed = 0; seed < 1000; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      String text = new ScriptPrinter(random).print(new RandomTrees(random).statements(3));
      ScriptAnalysis before = analysis(Source.of("seed", text));
      // A name that a built-in function has could not be given again.
      List<Occurrence> all =
          before.index().all().stream()
              .filter(found -> before.signatures().builtin(found.symbol().name()).isEmpty())
              .toList();
      if (all.isEmpty()) {
        continue;
      }
      Occurrence chosen = all.get(random.nextInt(all.size()));
      RenameResult there = before.rename(chosen.range().start(), "renamed");
      if (there instanceof RenameResult.Renamed(List<TextEdit> edits)) {
        ScriptAnalysis after = analysis(TextEdit.apply(before.source(), edits));
        assertEquals(before.references(chosen.range().start()).size(), edits.size());
        int place = edits.getFirst().range().start();
        RenameResult back = after.rename(place, chosen.symbol().name());
        RenameResult.Renamed undone =
            assertInstanceOf(
                RenameResult.Renamed.class, back, back + " in\n" + after.source().text());
        assertEquals(before.source().text(), TextEdit.apply(after.source(), undone.edits()).text());
        renamed++;
      }
    }
    assertTrue(renamed > 100, "only " + renamed + " names could be renamed");
  }

  private static ScriptAnalysis analysis(Source source) {
    return ScriptAnalysis.of(source, new EditorCatalogue());
  }

  private static void answerEverything(Source source, int offset) {
    ScriptAnalysis analysis = analysis(source);
    for (Completion offer : analysis.completions(offset)) {
      assertTrue(offer.caret() <= offer.insert().length(), offer.toString());
      assertTrue(offer.replaced().end() <= source.text().length(), offer.toString());
    }
    analysis.signatureHelp(offset);
    analysis.hover(offset);
    analysis.references(offset);
    analysis.rename(offset, "renamed");
    analysis.outline();
    analysis.folding();
    analysis.highlighting();
    analysis.breakpointLines();
    analysis.enclosingStatement(source.line(offset));
    analysis.format(FormatOptions.DEFAULT);
    analysis.diagnostics().forEach(analysis::fixes);
  }
}
