package org.pendant.language.service;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.pendant.language.parse.RandomEdits;
import org.pendant.language.source.Source;

/** An analysis that was made with the help of an earlier one says what one made anew says. */
final class ChangedTextTest {
  private static final int TEXTS = 15;
  private static final int EDITS = 10;

  @Test
  void anEditedTextIsAnsweredAsOneThatIsNew() {
    EditorCatalogue catalogue = new EditorCatalogue();
    for (int seed = 0; seed < TEXTS; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      RandomEdits edits = new RandomEdits(random);
      ScriptAnalysis analysis = ScriptAnalysis.of(edits.program("seed" + seed), catalogue);
      for (int i = 0; i < EDITS; i++) {
        Source before = analysis.source();
        Source source = edits.edited(before);
        int offset = random.nextInt(source.text().length() + 1);
        String about = "seed " + seed + " edit " + i + "\n" + before.text() + "\n=>\n";
        analysis = analysis.changed(source, catalogue);
        ScriptAnalysis whole = ScriptAnalysis.of(source, catalogue);
        // Completion first, as who types asks for it; what it needs must not wait for the rest.
        assertSame(about, whole, analysis, each -> each.completions(offset));
        assertSame(about, whole, analysis, ScriptAnalysis::diagnostics);
        assertSame(about, whole, analysis, ScriptAnalysis::outline);
        assertSame(about, whole, analysis, ScriptAnalysis::occurrences);
        assertSame(about, whole, analysis, ScriptAnalysis::highlighting);
        assertSame(about, whole, analysis, ScriptAnalysis::folding);
        assertSame(about, whole, analysis, ScriptAnalysis::definitions);
        assertSame(about, whole, analysis, ScriptAnalysis::calls);
      }
    }
  }

  private static <T> void assertSame(
      String about,
      ScriptAnalysis whole,
      ScriptAnalysis changed,
      Function<ScriptAnalysis, T> question) {
    assertEquals(question.apply(whole), question.apply(changed), about + whole.source().text());
  }
}
