package org.pendant.desktop.editor.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;

final class EditTest {
  private static final List<Edit> EDITS = List.of(Edit.insert(0, "ab"), Edit.replace(4, 6, ""));

  @Test
  void allEditsReferToTheTextBefore() {
    assertEquals("ab012367", Edit.apply("01234567", EDITS));
  }

  @Test
  void offsetsMoveWithTheirCharacters() {
    assertEquals(5, Edit.moved(3, EDITS));
    assertEquals(8, Edit.moved(8, EDITS));
  }

  @Test
  void anOffsetInReplacedTextStaysInIt() {
    assertEquals(6, Edit.moved(5, EDITS));
  }

  @Test
  void spansAreOrdered() {
    IllegalArgumentException refused =
        assertThrows(IllegalArgumentException.class, () -> new TextSpan(3, 2));
    assertEquals("span 3..2 is not ordered", refused.getMessage());
  }

  @Test
  void aSelectionThatEndsAtTheStartOfALineDoesNotTouchIt() {
    assertEquals(List.of(new TextSpan(0, 1)), LineIndex.touched("a\nb\n", new TextSpan(0, 2)));
    assertEquals(
        List.of(new TextSpan(0, 1), new TextSpan(2, 3)),
        LineIndex.touched("a\nb\n", new TextSpan(1, 3)));
  }

  @Test
  void theDifferenceOfTwoTextsIsAsSmallAsItCanBe() {
    assertEquals(Edit.replace(12, 13, "X"), Edit.difference(10, "abcd", "abXd"));
    assertEquals(Edit.insert(12, "a"), Edit.difference(10, "aa", "aaa"));
    assertEquals(Edit.replace(10, 14, ""), Edit.difference(10, "abcd", ""));
  }
}
