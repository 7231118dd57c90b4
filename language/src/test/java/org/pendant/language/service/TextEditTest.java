package org.pendant.language.service;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.Source;

final class TextEditTest {
  private static final Source SOURCE = Source.of("test.script", "abc def");

  @Test
  void editsReferToTheTextBeforeInAnyOrder() {
    List<TextEdit> edits =
        List.of(TextEdit.replace(4, 7, "x"), TextEdit.insert(0, "<"), TextEdit.replace(1, 2, "BB"));
    assertEquals("<aBBc x", TextEdit.apply(SOURCE, edits).text());
    assertEquals("test.script", TextEdit.apply(SOURCE, edits).name());
  }

  @Test
  void bytesThatAreNotAsciiStay() {
    Source source = Source.of("test.script", "\u00E9 x");
    Source edited = TextEdit.apply(source, List.of(TextEdit.replace(3, 4, "y")));
    assertEquals(Source.of("test.script", "\u00E9 y").text(), edited.text());
  }

  @Test
  void overlappingEditsAreRefused() {
    List<TextEdit> edits = List.of(TextEdit.replace(0, 3, ""), TextEdit.replace(2, 4, ""));
    IllegalArgumentException refused =
        assertThrows(IllegalArgumentException.class, () -> TextEdit.apply(SOURCE, edits));
    assertEquals("the edit at SourceRange[start=2, end=4] overlaps another", refused.getMessage());
  }

  @Test
  void placesBehindAnEditMoveWithIt() {
    List<TextEdit> edits = List.of(TextEdit.replace(1, 2, "BBB"), TextEdit.insert(4, "_"));
    assertEquals(0, TextEdit.moved(0, edits));
    assertEquals(1, TextEdit.moved(1, edits));
    assertEquals(5, TextEdit.moved(3, edits));
    assertEquals(7, TextEdit.moved(4, edits));
  }
}
