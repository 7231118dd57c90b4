package org.pendant.desktop.lines;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** Where lines are after edits. */
final class KeptLinesTest {
  private static final String TEXT = "a\nb\nc\nd\ne\n";

  @Test
  void linesOfTheSameTextStay() {
    assertEquals("[0, 1, 2, 3, 4, 5]", KeptLines.between(TEXT, TEXT).toString());
  }

  @Test
  void aLineThatSaysSomethingElseIsGone() {
    KeptLines kept = KeptLines.between(TEXT, "a\nb\nC\nd\ne\n");
    assertEquals(0, kept.now(3));
    assertEquals(4, kept.now(4));
  }

  @Test
  void linesMoveWithWhatIsWrittenAndDeletedInSeveralPlaces() {
    KeptLines kept = KeptLines.between(TEXT, "a\nnew\nb\nc\nE\ne\n");
    assertEquals(3, kept.now(2));
    assertEquals(4, kept.now(3));
    assertEquals(0, kept.now(4));
    assertEquals(6, kept.now(5));
  }

  @Test
  void anotherIndentationIsTheSameLine() {
    assertEquals(2, KeptLines.between("a\nb\n", "a\n    b\n").now(2));
  }

  @Test
  void linesThatWereNotThereAreNowhere() {
    KeptLines kept = KeptLines.between(TEXT, TEXT);
    assertEquals(0, kept.now(0));
    assertEquals(0, kept.now(6));
  }

  @Test
  void textsThatAreAllDifferentAreNotComparedForever() {
    String old = "old\n".repeat(5_000);
    assertEquals(0, KeptLines.between(old, "new\n".repeat(5_000)).now(2_500));
  }
}
