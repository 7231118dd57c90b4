package org.pendant.editors.lsp.provider;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.eclipse.lsp4j.CompletionItem;
import org.eclipse.lsp4j.CompletionItemTag;
import org.eclipse.lsp4j.FormattingOptions;
import org.eclipse.lsp4j.InsertTextFormat;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.SignatureHelp;
import org.eclipse.lsp4j.TextEdit;
import org.junit.jupiter.api.Test;
import org.pendant.editors.lsp.text.Document;

/** What helps while a text is typed: completion, signatures, layout. */
final class TypingTest {
  private static final FormattingOptions TWO_BLANKS = new FormattingOptions(2, true);

  private static CompletionItem item(String marked, String label, ClientFeatures client) {
    Texts place = Texts.of(marked);
    return Completions.at(place.document(), place.caret(), client).getItems().stream()
        .filter(each -> each.getLabel().equals(label))
        .findFirst()
        .orElseThrow();
  }

  private static String inserted(String marked, String label, ClientFeatures client) {
    return item(marked, label, client).getTextEdit().getLeft().getNewText();
  }

  @Test
  void aCallHasATabStopForEachArgumentThatItNeeds() {
    assertEquals("set_tcp(${1:pose})$0", inserted("set_t|", "set_tcp", Texts.ABLE));
    assertEquals(
        "get_actual_tcp_pose()", inserted("get_actual_tcp_p|", "get_actual_tcp_pose", Texts.ABLE));
  }

  @Test
  void clientsWithoutSnippetsGetPlainText() {
    CompletionItem item = item("set_t|", "set_tcp", ClientFeatures.LEAST);
    assertEquals(InsertTextFormat.PlainText, item.getInsertTextFormat());
    assertEquals("set_tcp()", item.getTextEdit().getLeft().getNewText());
  }

  @Test
  void theWordAtTheCaretIsReplaced() {
    assertEquals(
        new Range(new Position(1, 2), new Position(1, 7)),
        item("# ä\n  set_t|", "set_tcp", Texts.ABLE).getTextEdit().getLeft().getRange());
  }

  @Test
  void aListOfAWordIsNotTheListOfAnother() {
    Texts typed = Texts.of("mo|");
    assertTrue(Completions.at(typed.document(), typed.caret(), Texts.ABLE).isIncomplete());
    Texts fresh = Texts.of("x = |");
    assertFalse(Completions.at(fresh.document(), fresh.caret(), Texts.ABLE).isIncomplete());
  }

  @Test
  void functionsAreExplainedWhenTheClientAsks() {
    CompletionItem item = item("mov|", "movej", Texts.ABLE);
    assertNull(item.getDocumentation());
    assertEquals(Optional.of(Texts.URI), Completions.documentOf(item));
    Document document = Texts.document("");
    String explained =
        Completions.resolved(item, Optional.of(document.analysis().catalogue()), Texts.ABLE)
            .getDocumentation()
            .getRight()
            .getValue();
    assertTrue(explained.startsWith("```urscript\nmovej(q, a="), explained);
    assertTrue(explained.contains("rad/s²"), explained);
  }

  @Test
  void deprecatedFunctionsAreMarked() {
    assertEquals(
        List.of(CompletionItemTag.Deprecated),
        item("get_digital_i|", "get_digital_in", Texts.ABLE).getTags());
    assertNull(item("movej|", "movej", Texts.ABLE).getTags());
  }

  @Test
  void theArgumentAtTheCaretIsTheActiveOne() {
    Texts place = Texts.of("movel(p[0,0,0,0,0,0], |)");
    SignatureHelp help = SignatureHelps.at(place.document(), place.caret()).orElseThrow();
    assertEquals(1, help.getActiveParameter());
    var signature = help.getSignatures().getFirst();
    var active = signature.getParameters().get(1).getLabel().getRight();
    assertEquals("a=1.2", signature.getLabel().substring(active.getFirst(), active.getSecond()));
  }

  @Test
  void outsideCallsThereIsNoSignature() {
    Texts place = Texts.of("x = 1|");
    assertEquals(Optional.empty(), SignatureHelps.at(place.document(), place.caret()));
  }

  private static String laidOut(Document document, List<TextEdit> edits) {
    StringBuilder text = new StringBuilder(document.source().text());
    edits.stream()
        .sorted(
            (a, b) ->
                document.offset(b.getRange().getStart()) - document.offset(a.getRange().getStart()))
        .forEach(
            edit ->
                text.replace(
                    document.offset(edit.getRange().getStart()),
                    document.offset(edit.getRange().getEnd()),
                    edit.getNewText()));
    return text.toString();
  }

  @Test
  void aTextIsLaidOutWithTheBlanksOfTheEditor() {
    Document document = Texts.document("def f():\nx=1\nend\n");
    assertEquals(
        "def f():\n  x = 1\nend\n", laidOut(document, Formatting.of(document, TWO_BLANKS)));
    assertEquals(
        "def f():\n    x = 1\nend\n",
        laidOut(document, Formatting.of(document, new FormattingOptions(4, true))));
  }

  @Test
  void ofARangeOnlyItsLinesChange() {
    Document document = Texts.document("def f():\nx=1\ny=2\nend\n");
    Range second = new Range(new Position(1, 0), new Position(2, 0));
    assertEquals(
        "def f():\n  x = 1\ny=2\nend\n",
        laidOut(document, Formatting.of(document, second, TWO_BLANKS)));
  }

  @Test
  void theEndOfABlockGoesWhereItBelongsWhenItIsTyped() {
    Document document = Texts.document("def f():\n  x=1\n  end");
    assertEquals(
        "def f():\n  x=1\nend",
        laidOut(document, Formatting.onType(document, new Position(2, 5), TWO_BLANKS)));
  }

  @Test
  void aTextThatCannotBeReadStaysAsItIs() {
    Document document = Texts.document("def f(:\nx=1\n");
    assertEquals(List.of(), Formatting.of(document, TWO_BLANKS));
  }
}
