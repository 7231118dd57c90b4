package org.pendant.desktop.debug;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

final class LineMapTest {
  private static final String TEXT = "one\ntwo\nthree\nfour\n";

  private static List<Integer> now(String text) {
    LineMap map = LineMap.between(TEXT, text);
    return IntStream.rangeClosed(1, 5).map(map::toNow).boxed().toList();
  }

  @Test
  void anUnchangedTextHasItsLinesWhereTheyWere() {
    assertTrue(LineMap.between(TEXT, TEXT).unchanged());
    assertEquals(List.of(1, 2, 3, 4, 5), now(TEXT));
  }

  @Test
  void linesBehindAnInsertionMoveDown() {
    assertEquals(List.of(1, 2, 4, 5, 6), now("one\ntwo\nnew\nthree\nfour\n"));
    assertEquals(List.of(3, 4, 5, 6, 7), now("a\nb\n" + TEXT));
    assertFalse(LineMap.between(TEXT, "a\n" + TEXT).unchanged());
  }

  @Test
  void linesBehindADeletionMoveUp() {
    assertEquals(4, LineMap.between(TEXT, "one\nthree\nfour\n").toNow(5));
    assertEquals(3, LineMap.between(TEXT, "one\nthree\nfour\n").toNow(4));
    assertEquals(1, LineMap.between(TEXT, "").toNow(4));
  }

  @Test
  void aChangeWithinALineMovesNothing() {
    assertEquals(List.of(1, 2, 3, 4, 5), now("one\ntwo and more\nthree\nfour\n"));
  }

  @Test
  void theWayBackLeadsToTheSameLine() {
    LineMap map = LineMap.between(TEXT, "zero\none\ntwo\nthree\nfour\n");
    for (int line = 1; line <= 5; line++) {
      assertEquals(line, map.toOld(map.toNow(line)));
    }
    assertEquals(0, map.toNow(0), "no line stays no line");
  }
}
