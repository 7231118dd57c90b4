package org.pendant.editors.lsp.provider;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.eclipse.lsp4j.DocumentHighlightKind;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextEdit;
import org.eclipse.lsp4j.jsonrpc.ResponseErrorException;
import org.junit.jupiter.api.Test;

/** What names mean: hovers, definitions, uses, new names, calls. */
final class NameAnswersTest {
  private static final String CELL =
      """
      def cell():
        def pick(height):
          return height
        end
        thread blink():
          pick(1)
        end
        pick(0.1)
        run blink()
        if True:
          pick(0.2)
        else:
          pick(0.3)
        end
      end
      """;

  private static Texts at(String word, String marked) {
    return Texts.of(CELL.replaceFirst(Pattern.quote(word), marked));
  }

  private static String place(Range range) {
    return (range.getStart().getLine() + 1)
        + ":"
        + range.getStart().getCharacter()
        + "-"
        + range.getEnd().getCharacter();
  }

  private static String hover(String marked) {
    Texts place = Texts.of(marked);
    return Hovers.at(place.document(), place.caret(), ClientFeatures.LEAST)
        .map(hover -> hover.getContents().getRight().getValue())
        .orElse("nothing");
  }

  @Test
  void aFunctionIsExplainedWithItsUnits() {
    String text = hover("sle|ep(1)");
    assertTrue(text.startsWith("sleep(t)\n"), text);
    assertTrue(text.contains("t: number in s"), text);
  }

  @Test
  void aBuiltInNamesItsResultAndItsUnit() {
    assertTrue(hover("x = nor|m([1, 2])").contains("\nResult: number\n"));
    assertTrue(hover("x = force|()").contains("\nResult: number in N\n"), hover("x = force|()"));
  }

  @Test
  void aNumberIsToldInTheOtherUnitToo() {
    assertEquals("v = 1.5 rad/s = 85.944°/s", hover("movej(q, v=1|.5)"));
    assertEquals("z = 0.4 m = 400 mm", hover("x = p[0, 0, 0|.4, 0, 0, 0]"));
  }

  @Test
  void aPoseIsToldInMillimetresAndDegrees() {
    assertEquals(
        """
        x 100 mm, y 0 mm, z 400 mm
        rotation vector 180°, 0°, 0°
        roll 180°, pitch 0°, yaw 0°\
        """,
        hover("x = p|[0.1, 0, 0.4, 3.14159265, 0, 0]"));
  }

  @Test
  void markedUpTextShowsSignsAsTheyAre() {
    Texts place = Texts.of("# a_b *c*\ndef f|(x):\nend");
    assertEquals(
        "```urscript\ndef f(x)\n```\na\\_b \\*c\\*  \nDefined on line 2.",
        Hovers.at(place.document(), place.caret(), Texts.ABLE)
            .orElseThrow()
            .getContents()
            .getRight()
            .getValue());
  }

  @Test
  void aCallLeadsToItsDefinition() {
    Texts place = at("pick(0.1)", "pi|ck(0.1)");
    assertEquals(
        "2:6-10",
        place(Names.definition(place.document(), place.caret()).orElseThrow().getRange()));
  }

  @Test
  void referencesAreWithOrWithoutTheDeclaration() {
    Texts place = at("pick(0.1)", "pi|ck(0.1)");
    assertEquals(5, Names.references(place.document(), place.caret(), true).size());
    assertEquals(4, Names.references(place.document(), place.caret(), false).size());
  }

  @Test
  void usesAreReadAndAssignmentsWritten() {
    Texts place = Texts.of("a| = 1\nb = a");
    assertEquals(
        List.of(DocumentHighlightKind.Write, DocumentHighlightKind.Read),
        Names.highlights(place.document(), place.caret()).stream()
            .map(each -> each.getKind())
            .toList());
  }

  @Test
  void theWordsOfABlockAreShownTogether() {
    Texts place = at("else:", "el|se:");
    assertEquals(
        List.of("10:2-4", "12:2-6", "14:2-5"),
        Names.highlights(place.document(), place.caret()).stream()
            .map(each -> place(each.getRange()))
            .toList());
  }

  @Test
  void aNewNameIsGivenEverywhere() {
    Texts place = at("pick(0.1)", "pi|ck(0.1)");
    List<TextEdit> edits =
        Names.renamed(place.document(), place.caret(), "grip").getChanges().get(Texts.URI);
    assertEquals(5, edits.size());
    assertEquals("grip", edits.getFirst().getNewText());
  }

  @Test
  void whatCannotBeRenamedSaysWhy() {
    Texts builtin = Texts.of("sle|ep(1)");
    assertEquals(Optional.empty(), Names.renamable(builtin.document(), builtin.caret()));
    Texts own = at("pick(0.1)", "pi|ck(0.1)");
    assertEquals(
        "pick", Names.renamable(own.document(), own.caret()).orElseThrow().getPlaceholder());
    ResponseErrorException refused =
        assertThrows(
            ResponseErrorException.class,
            () -> Names.renamed(own.document(), own.caret(), "while"));
    assertTrue(refused.getMessage().contains("while"), refused.getMessage());
  }

  @Test
  void callsOfAFunctionAreGroupedByWhoCalls() {
    Texts place = at("pick(0.1)", "pi|ck(0.1)");
    var item = CallHierarchies.at(place.document(), place.caret()).getFirst();
    assertEquals(
        List.of("blink 1", "cell 3"),
        CallHierarchies.incoming(place.document(), item).stream()
            .map(call -> call.getFrom().getName() + " " + call.getFromRanges().size())
            .toList());
  }

  @Test
  void whatAProgramCallsIncludesTheThreadsThatItStarts() {
    Texts place = at("cell()", "ce|ll()");
    var item = CallHierarchies.at(place.document(), place.caret()).getFirst();
    assertEquals(
        List.of("pick 3", "blink 1"),
        CallHierarchies.outgoing(place.document(), item).stream()
            .map(call -> call.getTo().getName() + " " + call.getFromRanges().size())
            .toList());
  }
}
