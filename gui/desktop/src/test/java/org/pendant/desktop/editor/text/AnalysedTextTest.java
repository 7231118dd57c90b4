package org.pendant.desktop.editor.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.language.service.RenameResult;
import org.pendant.testing.builtin.TestCatalogue;

final class AnalysedTextTest {
  /** Each accented letter is one character and two bytes. */
  private static final String ACCENTS =
      "def main():\n  # \u00e9\u00e9\u00e9\n  speed = 1\n  textmsg(\"\u00e9\", speed)\nend\n";

  private static AnalysedText analyse(String text) {
    return AnalysedText.of("test.script", text, StandardBuiltins.create());
  }

  @Test
  void placesOfNamesCountCharactersBehindAccents() {
    int use = ACCENTS.lastIndexOf("speed");
    int origin = ACCENTS.indexOf("speed");

    assertEquals(Optional.of(new TextSpan(origin, origin + 5)), analyse(ACCENTS).definition(use));
    assertEquals(
        List.of(new TextSpan(origin, origin + 5), new TextSpan(use, use + 5)),
        analyse(ACCENTS).references(use));
  }

  @Test
  void renamingChangesTheSameCharactersBehindAccents() {
    AnalysedText analysed = analyse(ACCENTS);
    int byteOffset = analysed.toByte(ACCENTS.indexOf("speed"));
    RenameResult.Renamed renamed =
        assertInstanceOf(
            RenameResult.Renamed.class, analysed.analysis().rename(byteOffset, "fast"));

    assertEquals(
        ACCENTS.replace("speed", "fast"), Edit.apply(ACCENTS, analysed.edits(renamed.edits())));
  }

  @Test
  void problemsKnowLineAndColumnInCharacters() {
    Problem problem = analyse("\u00e9 = 1\n").problems().getFirst();
    assertEquals(1, problem.line());

    Problem unknown =
        analyse("def main():\n  textmsg(\"\u00e9\", nothing)\nend\n").problems().getFirst();
    assertEquals(2, unknown.line());
    assertEquals(16, unknown.column());
    assertEquals(7, unknown.span().end() - unknown.span().start());
  }

  @Test
  void offersTheProblemUnderTheCaretBeforeOthersOfTheLine() {
    AnalysedText analysed = analyse("def main():\n  textmsg(one, two)\nend\n");
    int two = analysed.text().indexOf("two");

    assertEquals(1, analysed.problemsAt(two).size());
    assertEquals(two, analysed.problemsAt(two).getFirst().span().start());
    assertEquals(2, analysed.problemsAt(analysed.text().indexOf("textmsg")).size());
    assertEquals(List.of(), analysed.problemsAt(0));
  }

  @Test
  void quickFixesPutAMisspelledFunctionRight() {
    AnalysedText analysed = analyse("def main():\n  textmsgg(\"\u00e9\")\nend\n");
    Problem problem = analysed.problems().getFirst();

    assertFalse(analysed.fixes(problem).isEmpty());
    List<Edit> edits = analysed.edits(analysed.fixes(problem).getFirst().edits());
    assertEquals("def main():\n  textmsg(\"\u00e9\")\nend\n", Edit.apply(analysed.text(), edits));
  }

  @Test
  void aFileOfTestsMayCallWhatTestsMayAndWhatItImports() {
    String text =
        """
        import_script("pick.script")
        def test_grip():
          assert_near(width_of(3), 0.1)
          eventually(get_standard_digital_out(0), within=2)
          assert_nera(1, 2, 3)
        end
        """;
    AnalysedText tests = AnalysedText.of("pick_test.script", text, new TestCatalogue());
    AnalysedText without =
        AnalysedText.of(
            "pick_test.script", text.substring(text.indexOf('\n') + 1), new TestCatalogue());

    assertEquals(List.of(), tests.problems());
    assertEquals(2, without.problems().size());
  }
}
