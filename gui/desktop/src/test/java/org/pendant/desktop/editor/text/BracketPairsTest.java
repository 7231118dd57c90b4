package org.pendant.desktop.editor.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.pendant.desktop.editor.text.BracketPairs.Deed;

/** {@code |} is the caret. */
final class BracketPairsTest {

  private static Deed typed(String marked, char c) {
    int caret = marked.indexOf('|');
    return BracketPairs.typed(marked.replace("|", ""), caret, c);
  }

  private static boolean pair(String marked) {
    return BracketPairs.isEmptyPair(marked.replace("|", ""), marked.indexOf('|'));
  }

  @Test
  void anOpeningBracketBringsItsOtherHalf() {
    assertEquals(Deed.INSERT_PAIR, typed("movej|", '('));
    assertEquals(Deed.INSERT_PAIR, typed("movej(|)", '['));
    assertEquals(Deed.INSERT_PAIR, typed("f(|, 2)", '('));
    assertEquals(Deed.INSERT_PAIR, typed("textmsg(|)", '"'));
  }

  @Test
  void itComesAloneWhereSomethingFollows() {
    assertEquals(Deed.INSERT, typed("x = |count + 1", '('));
    assertEquals(Deed.INSERT, typed("x = |1)", '('));
    assertEquals(Deed.INSERT, typed("x = | + 1)", '('));
    assertEquals(Deed.INSERT, typed("textmsg(|count)", '"'));
  }

  @Test
  void aClosingBracketThatIsThereIsSteppedOver() {
    assertEquals(Deed.STEP_OVER, typed("movej([1]|)", ')'));
    assertEquals(Deed.STEP_OVER, typed("x = [1|]", ']'));
    assertEquals(Deed.STEP_OVER, typed("textmsg(\"a|\")", '"'));
    assertEquals(Deed.INSERT, typed("x = f((1|)", ')'));
    assertEquals(Deed.INSERT, typed("x = f(1|", ')'));
  }

  @Test
  void stringsAndCommentsAreLeftAlone() {
    assertEquals(Deed.INSERT, typed("textmsg(\"see |\")", '('));
    assertEquals(Deed.INSERT, typed("x = 1 # see |", '('));
    assertEquals(Deed.INSERT, typed("x = 1 # so called |", '"'));
    assertEquals(Deed.INSERT, typed("name|", '"'));
  }

  @Test
  void anEmptyPairGoesAsAWhole() {
    assertTrue(pair("movej(|)"));
    assertTrue(pair("textmsg(\"|\")"));
    assertFalse(pair("movej(1|)"));
    assertFalse(pair("movej((|)"));
    assertFalse(pair("(|"));
    assertFalse(pair("|)"));
  }
}
