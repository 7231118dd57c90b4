package org.pendant.editors.lsp.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextDocumentContentChangeEvent;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.ByteText;

/** Texts that a client changes piece by piece. */
final class DocumentTest {
  private static final PositionEncoding UTF16 = PositionEncoding.UTF16;

  private static Document document(String text) {
    return Document.of("file:///a.script", 1, text, new Catalogues().of("a.script"), UTF16);
  }

  private static TextDocumentContentChangeEvent change(
      int line, int from, int endLine, int to, String text) {
    return new TextDocumentContentChangeEvent(
        new Range(new Position(line, from), new Position(endLine, to)), text);
  }

  private static String text(Document document) {
    return ByteText.decoded(document.source().text());
  }

  @Test
  void eachChangeIsOneOfWhatTheOneBeforeHasLeft() {
    Document changed =
        document("x = 1\ny = 2\n")
            .changed(2, List.of(change(0, 4, 0, 5, "µ"), change(0, 5, 1, 0, "; ")), UTF16);
    assertEquals("x = µ; y = 2\n", text(changed));
    assertEquals(2, changed.version());
  }

  @Test
  void aChangeWithoutARangeIsTheWholeText() {
    Document changed =
        document("x = 1").changed(2, List.of(new TextDocumentContentChangeEvent("y")), UTF16);
    assertEquals("y", text(changed));
  }

  @Test
  void anEarlierVersionStaysAsItIs() {
    Document first = document("x = 1");
    first.changed(2, List.of(change(0, 0, 0, 5, "")), UTF16);
    assertEquals("x = 1", text(first));
    assertEquals(1, first.version());
  }

  @Test
  void aTextThatGetsTooLongIsRefused() {
    String half = "#".repeat(Document.MAX_BYTES / 2 + 1);
    Document document = document(half);
    IllegalArgumentException refused =
        assertThrows(
            IllegalArgumentException.class,
            () -> document.changed(2, List.of(change(0, 0, 0, 0, half)), UTF16));
    assertEquals("file:///a.script has 16777218 bytes, the most is 16777216", refused.getMessage());
  }

  @Test
  void anySequenceOfChangesMakesTheTextThatAClientHas() {
    Random random = new Random(11);
    List<String> pieces = List.of("a", "ß", "🤖", "\n", "def f():\n", "end\n", "");
    for (int round = 0; round < 100; round++) {
      StringBuilder expected = new StringBuilder("x = 1\n# ä\nend");
      Document document = document(expected.toString());
      for (int version = 2; version < 8; version++) {
        List<TextDocumentContentChangeEvent> changes = new ArrayList<>();
        String piece = pieces.get(random.nextInt(pieces.size()));
        int[] ends =
            random
                .ints(2, 0, expected.length() + 1)
                .map(at -> whole(expected, at))
                .sorted()
                .toArray();
        changes.add(
            new TextDocumentContentChangeEvent(
                new Range(position(expected, ends[0]), position(expected, ends[1])), piece));
        expected.replace(ends[0], ends[1], piece);
        document = document.changed(version, changes, UTF16);
        assertEquals(expected.toString(), text(document));
      }
    }
  }

  /** A place between two characters. */
  private static int whole(CharSequence text, int at) {
    boolean inside = at > 0 && at < text.length() && Character.isLowSurrogate(text.charAt(at));
    return inside ? at - 1 : at;
  }

  private static Position position(StringBuilder text, int at) {
    int line = (int) text.substring(0, at).chars().filter(each -> each == '\n').count();
    return new Position(line, at - text.lastIndexOf("\n", at - 1) - 1);
  }
}
