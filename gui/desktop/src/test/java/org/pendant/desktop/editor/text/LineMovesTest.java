package org.pendant.desktop.editor.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

final class LineMovesTest {
  private static final String TEXT = "one\ntwo\nthree";

  private static List<TextSpan> lines(int start, int end) {
    return LineIndex.touched(TEXT, new TextSpan(start, end));
  }

  private static String moved(int start, int end, boolean down) {
    LineMoves move = LineMoves.moved(TEXT, lines(start, end), down).orElseThrow();
    return Edit.apply(TEXT, List.of(move.edit())) + " by " + move.shift();
  }

  @Test
  void linesChangePlacesWithTheirNeighbour() {
    assertEquals("two\none\nthree by 4", moved(1, 1, true));
    assertEquals("two\none\nthree by -4", moved(5, 5, false));
    assertEquals("one\nthree\ntwo by -4", moved(9, 9, false));
    assertEquals("three\none\ntwo by 6", moved(1, 6, true));
  }

  @Test
  void nothingMovesOverTheEdge() {
    assertTrue(LineMoves.moved(TEXT, lines(1, 1), false).isEmpty());
    assertTrue(LineMoves.moved(TEXT, lines(9, 9), true).isEmpty());
  }

  @Test
  void linesAreWrittenTwiceAndTakenAway() {
    LineMoves twice = LineMoves.duplicated(TEXT, lines(5, 5));
    assertEquals("one\ntwo\ntwo\nthree", Edit.apply(TEXT, List.of(twice.edit())));
    assertEquals(4, twice.shift());
    assertEquals("one\nthree", Edit.apply(TEXT, List.of(LineMoves.deleted(TEXT, lines(5, 5)))));
    assertEquals("one\ntwo", Edit.apply(TEXT, List.of(LineMoves.deleted(TEXT, lines(9, 9)))));
    assertEquals("", Edit.apply(TEXT, List.of(LineMoves.deleted(TEXT, lines(0, 13)))));
  }
}
