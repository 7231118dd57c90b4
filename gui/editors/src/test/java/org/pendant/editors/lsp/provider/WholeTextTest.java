package org.pendant.editors.lsp.provider;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.eclipse.lsp4j.CodeAction;
import org.eclipse.lsp4j.CodeActionContext;
import org.eclipse.lsp4j.CodeActionKind;
import org.eclipse.lsp4j.CodeActionParams;
import org.eclipse.lsp4j.DiagnosticSeverity;
import org.eclipse.lsp4j.DiagnosticTag;
import org.eclipse.lsp4j.DocumentSymbol;
import org.eclipse.lsp4j.InlayHint;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.SelectionRange;
import org.eclipse.lsp4j.SemanticTokensEdit;
import org.eclipse.lsp4j.TextDocumentIdentifier;
import org.junit.jupiter.api.Test;
import org.pendant.editors.dryrun.DryRun;
import org.pendant.editors.dryrun.DryRunLimits;
import org.pendant.editors.dryrun.DryRunResult;
import org.pendant.editors.lsp.text.Document;

/** What is told of a text as a whole: mistakes, symbols, colours, hints. */
final class WholeTextTest {
  private static final Range ALL = new Range(new Position(0, 0), new Position(99, 0));

  @Test
  void aMistakeHasItsPlaceItsCodeAndItsWords() {
    var diagnostic =
        DiagnosticAnswers.of(Texts.document("# ä\nmovje([0,0,0,0,0,0])"), Texts.ABLE).getFirst();
    assertEquals(new Range(new Position(1, 0), new Position(1, 5)), diagnostic.getRange());
    assertEquals(DiagnosticSeverity.Error, diagnostic.getSeverity());
    assertEquals("pendant", diagnostic.getSource());
    assertTrue(diagnostic.getMessage().contains("movej"), diagnostic.getMessage());
  }

  @Test
  void whatNeverRunsIsShownFaded() {
    var diagnostic =
        DiagnosticAnswers.of(Texts.document("def f():\n  return 1\n  sleep(1)\nend"), Texts.ABLE)
            .getFirst();
    assertEquals(DiagnosticSeverity.Warning, diagnostic.getSeverity());
    assertEquals(List.of(DiagnosticTag.Unnecessary), diagnostic.getTags());
  }

  @Test
  void testsMayCallMoreThanPrograms() {
    String test = "def test_it():\n  assert_true(True)\nend\n";
    assertEquals(
        List.of(),
        DiagnosticAnswers.of(Texts.document("file:///cell_test.script", test), Texts.ABLE));
    assertFalse(DiagnosticAnswers.of(Texts.document(test), Texts.ABLE).isEmpty());
  }

  @Test
  @SuppressWarnings("deprecation") // what clients without nested symbols understand
  void symbolsAreInsideEachOther() {
    Document document = Texts.document("def cell():\n  count = 0\n  def pick(h):\n  end\nend");
    DocumentSymbol cell = Symbols.of(document, Texts.ABLE).getFirst().getRight();
    assertEquals("cell", cell.getName());
    assertEquals(
        List.of("count", "pick"),
        cell.getChildren().stream().map(DocumentSymbol::getName).toList());
    assertEquals(
        List.of("cell in ", "count in cell", "pick in cell"),
        Symbols.of(document, ClientFeatures.LEAST).stream()
            .map(each -> each.getLeft().getName() + " in " + each.getLeft().getContainerName())
            .toList());
  }

  @Test
  void aQueryFindsNamesByTheirLettersInOrder() {
    Symbols.Found found = Symbols.flat(Texts.document("def pick_part():\nend")).getFirst();
    assertTrue(Symbols.matches(found, "PP"));
    assertTrue(Symbols.matches(found, ""));
    assertFalse(Symbols.matches(found, "tp"));
  }

  @Test
  void blocksAndCommentsFold() {
    assertEquals(
        List.of("0-1 comment", "2-3 null"),
        Structure.folding(Texts.document("# a\n# b\nif x:\n  y = 1\nend")).stream()
            .map(each -> each.getStartLine() + "-" + each.getEndLine() + " " + each.getKind())
            .toList());
  }

  @Test
  void aSelectionGrowsFromTheWordToTheText() {
    Texts place = Texts.of("def f():\n  movej(get_inverse_kin(pla|ce), 1)\nend\n");
    List<String> grown = new ArrayList<>();
    SelectionRange range = Structure.selection(place.document(), place.caret());
    while (range != null) {
      grown.add(
          place.document().source().text(place.document().positions().range(range.getRange())));
      range = range.getParent();
    }
    assertEquals(
        List.of(
            "place",
            "get_inverse_kin(place)",
            "movej(get_inverse_kin(place), 1)",
            "def f():\n  movej(get_inverse_kin(place), 1)\nend"),
        grown.stream().map(String::strip).distinct().toList());
  }

  @Test
  void coloursAreFiveNumbersEach() {
    // def | f | return | 1.5 | end
    assertEquals(
        List.of(0, 0, 3, 0, 0, 0, 4, 1, 1, 2, 1, 2, 6, 0, 0, 0, 7, 3, 5, 0, 1, 0, 3, 0, 0),
        withoutSigns(Tokens.of(Texts.document("def f():\n  return 1.5\nend"))));
  }

  /** Brackets and colons may have the colour of operators. */
  private static List<Integer> withoutSigns(List<Integer> numbers) {
    for (int i = 3; i < numbers.size(); i += 5) {
      assertTrue(numbers.get(i) >= 0 && numbers.get(i) < 10);
    }
    return numbers;
  }

  @Test
  void coloursOfARangeAreThoseInIt() {
    Document document = Texts.document("a = 1\nb = 2\nc = 3");
    List<Integer> second = Tokens.of(document, new Range(new Position(1, 0), new Position(1, 5)));
    assertEquals(1, second.getFirst());
    assertTrue(second.size() < Tokens.of(document).size());
  }

  @Test
  void editsOfColoursMakeTheNewOnesOfTheOld() {
    Random random = new Random(5);
    List<String> lines = List.of("a = 1", "movej(q)", "# x", "if True:", "end", "b = \"c\"");
    List<Integer> before = List.of();
    for (int round = 0; round < 100; round++) {
      StringBuilder text = new StringBuilder();
      for (int i = random.nextInt(8); i > 0; i--) {
        text.append(lines.get(random.nextInt(lines.size()))).append('\n');
      }
      List<Integer> after = Tokens.of(Texts.document(text.toString()));
      List<Integer> edited = new ArrayList<>(before);
      for (SemanticTokensEdit edit : Tokens.edits(before, after)) {
        edited.subList(edit.getStart(), edit.getStart() + edit.getDeleteCount()).clear();
        edited.addAll(edit.getStart(), edit.getData());
      }
      assertEquals(after, edited);
      before = after;
    }
  }

  private static List<CodeAction> actions(Document document, Range range, String... kinds) {
    CodeActionContext context = new CodeActionContext(List.of());
    if (kinds.length > 0) {
      context.setOnly(List.of(kinds));
    }
    return CodeActions.of(
        document,
        new CodeActionParams(new TextDocumentIdentifier(Texts.URI), range, context),
        Texts.ABLE);
  }

  @Test
  void aMistakeOffersWhatPutsItRight() {
    Document document = Texts.document("movje([0,0,0,0,0,0])");
    CodeAction fix =
        actions(document, new Range(new Position(0, 2), new Position(0, 2))).getFirst();
    assertEquals("Replace by movej", fix.getTitle());
    assertEquals("movej", fix.getEdit().getChanges().get(Texts.URI).getFirst().getNewText());
    assertEquals(List.of(), actions(document, new Range(new Position(0, 9), new Position(0, 9))));
  }

  @Test
  void allThatHasOneWayIsPutRightAtOnce() {
    Document document = Texts.document("slep(1)\nsleep(2)\nslep(3)\n");
    CodeAction all = actions(document, ALL, CodeActionKind.SourceFixAll).getFirst();
    assertEquals(2, all.getEdit().getChanges().get(Texts.URI).size());
    assertTrue(actions(document, ALL, CodeActionKind.Refactor).isEmpty());
  }

  @Test
  void aDryRunThatIsGivenUpTellsWhatALineTookAtLeast() {
    Document document =
        Texts.document("while True:\n  movej([0, -1.2, 0, -1.57, 0, 0], v=0.1)\nend\n");
    DryRunResult result =
        DryRun.of(
            document.source(),
            "ur5e",
            new DryRunLimits(Duration.ofSeconds(1), Duration.ofMinutes(2)),
            () -> false);
    Range all = new Range(new Position(0, 0), new Position(4, 0));
    List<String> told =
        DryRunAnswers.hints(document, all, result, Texts.ABLE).stream()
            .map(hint -> hint.getLabel().getLeft())
            .toList();
    assertTrue(
        told.size() == 1 && told.getFirst().matches("\u2265 [01]\\.\\d\\d s"), told::toString);
  }

  private static List<String> hints(String text, HintSettings settings) {
    return InlayHints.of(Texts.document(text), ALL, settings, Texts.ABLE).stream()
        .map(WholeTextTest::shown)
        .toList();
  }

  private static String shown(InlayHint hint) {
    return hint.getPosition().getCharacter() + " " + hint.getLabel().getLeft();
  }

  @Test
  void parametersAreNamedWhereTheCallDoesNotSayThem() {
    assertEquals(
        List.of("6 q:", "13 a:"),
        hints("movej(place, accel, v=speed)", new HintSettings(true, false, false, false)));
    assertEquals(
        List.of(), hints("def f(x):\nend\nf(x)", new HintSettings(true, false, false, false)));
  }

  @Test
  void numbersHaveTheirUnitsAndPosesMillimetresAndDegrees() {
    assertEquals(List.of("9 s"), hints("sleep(0.5)", new HintSettings(false, true, false, false)));
    assertEquals(
        List.of("36 100, 0, 400 mm · RPY 180°, 0°, 0°"),
        hints("x = p[0.1, 0, 0.4, 3.14159265, 0, 0]", new HintSettings(false, false, true, false)));
  }

  private static List<String> lenses(Document document) {
    return CodeLenses.of(document, Optional.of("4.2 s"), Texts.ABLE).stream()
        .map(
            lens ->
                lens.getRange().getStart().getLine()
                    + " "
                    + lens.getCommand().getTitle()
                    + lens.getCommand().getArguments())
        .toList();
  }

  @Test
  void aProgramCanBeRunWhereItBegins() {
    assertEquals(
        List.of("1 Run[" + Texts.URI + "]", "1 Debug[" + Texts.URI + "]", "1 4.2 s[]"),
        lenses(Texts.document("# hello\ndef cell():\n  sleep(1)\nend")));
    assertEquals(List.of(), lenses(Texts.document("# nothing yet")));
  }

  @Test
  void eachTestCanBeRunAlone() {
    String uri = "file:///cell_test.script";
    assertEquals(
        List.of("2 Run test[" + uri + ", test_b]", "2 Debug test[" + uri + ", test_b]"),
        lenses(Texts.document(uri, "def helper():\nend\ndef test_b():\nend")));
  }
}
