package org.pendant.desktop.editor.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;

final class FindStateTest {
  private static final String TEXT = "move Move movel\nmove(1)\n";

  private static FindState find(String words, boolean matchCase, boolean whole, boolean regex) {
    return FindState.of(new SearchQuery(words, matchCase, whole, regex), TEXT);
  }

  @Test
  void capitalsCountOnlyWhenAsked() {
    assertEquals(4, find("move", false, false, false).matches().size());
    assertEquals(3, find("move", true, false, false).matches().size());
  }

  @Test
  void wholeWordsLeaveLongerNamesOut() {
    assertEquals(3, find("move", false, true, false).matches().size());
  }

  @Test
  void signsOfExpressionsAreOrdinaryUnlessAsked() {
    assertEquals(List.of(new TextSpan(20, 23)), find("(1)", false, false, false).matches());
    assertEquals(List.of(new TextSpan(21, 22)), find("(1)", false, false, true).matches());
  }

  @Test
  void goesRoundAtBothEnds() {
    FindState state = find("move", false, false, false);
    assertEquals(1, state.from(1));
    assertEquals(0, state.from(20));
    assertEquals(0, state.before(5));
    assertEquals(3, state.before(0));
  }

  @Test
  void saysHowManyAndWhich() {
    FindState state = find("move", false, false, false);
    assertEquals("2 of 4", state.summary(new TextSpan(5, 9)));
    assertEquals("4 matches", state.summary(new TextSpan(0, 0)));
    assertEquals("No match", find("jog", false, false, false).summary(new TextSpan(0, 0)));
    assertEquals("", find("", false, false, false).summary(new TextSpan(0, 0)));
  }

  @Test
  void saysWhatIsWrongWithAnExpression() {
    assertEquals(
        "Unclosed group at the end", find("(a", false, false, true).summary(new TextSpan(0, 0)));
  }

  @Test
  void anExpressionThatWouldRunForeverEnds() {
    String text = "a".repeat(40) + "!";
    assertEquals(
        List.of(), new SearchQuery("(a|aa)+$", false, false, true).in(text).stream().toList());
  }

  @Test
  void replacesEveryMatchWithGroupsFilledIn() {
    FindState state = find("move(\\w*)", true, false, true);
    assertEquals("go_ Move go_l\ngo_(1)\n", Edit.apply(TEXT, state.replaceAll(TEXT, "go_$1")));
  }

  @Test
  void dollarsAreOrdinaryWithoutExpressions() {
    FindState state = find("(1)", false, false, false);
    assertEquals("move Move movel\nmove$1\n", Edit.apply(TEXT, state.replaceAll(TEXT, "$1")));
  }

  @Test
  void refusesAGroupThatIsNotThere() {
    FindState state = find("move", true, false, true);
    IllegalArgumentException refused =
        assertThrows(IllegalArgumentException.class, () -> state.replaceAll(TEXT, "$7"));
    assertEquals("$7 names a group that is not there", refused.getMessage());
  }

  @Test
  void saysOneAndMoreThanCanBeMarked() {
    assertEquals("1 match", find("(1)", false, false, false).summary(new TextSpan(0, 0)));
    String many = "a ".repeat(SearchQuery.MAX_MATCHES + 1);
    FindState state = FindState.of(new SearchQuery("a", false, false, false), many);
    int most = SearchQuery.MAX_MATCHES;
    assertEquals(most + " or more matches", state.summary(new TextSpan(1, 1)));
    assertEquals("2 of " + most + " or more", state.summary(new TextSpan(2, 3)));
  }

  @Test
  void saysAtWhichCharacterAnExpressionIsWrong() {
    String wrong = find("a**b", false, false, true).summary(new TextSpan(0, 0));
    assertEquals("Dangling meta character '*' at character 3", wrong);
  }
}
