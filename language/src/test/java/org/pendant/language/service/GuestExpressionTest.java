package org.pendant.language.service;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.Source;

/** Expressions that are read at a line of a text without being in it. */
final class GuestExpressionTest {
  private static final String PROGRAM =
      """
      def prog():
        global count = 0
        def weigh(number):
          doubled = number * 2
          return doubled
        end
        while count < 10:
          count = count + weigh(1)
        end
      end
      """;

  private static GuestExpression guest(String text, int line, String expression) {
    return GuestExpression.of(
        Source.of("test.script", text), new EditorCatalogue(), line, expression);
  }

  private static String problem(int line, String expression) {
    return guest(PROGRAM, line, expression)
        .problem()
        .map(found -> found.range().start() + "-" + found.range().end() + " " + found.code())
        .orElse("");
  }

  @Test
  void namesMeanWhatTheyMeanAtTheLine() {
    assertEquals("", problem(5, "doubled > 4 and count == number"));
    assertEquals("", problem(8, "count > 4 or weigh(2) == 4"));
    assertTrue(problem(8, "count > missing").startsWith("8-15 "), problem(8, "count > missing"));
  }

  @Test
  void whatIsNoExpressionIsRefused() {
    for (String wrong :
        List.of(
            "count = 5", "True: x = 1", "count > 1) or (True", "(count", "halt", "True # yes")) {
      assertTrue(problem(8, wrong).endsWith("not-an-expression"), wrong + problem(8, wrong));
    }
    assertTrue(!problem(8, "count >").isEmpty());
    assertTrue(!problem(8, "count 5").isEmpty());
  }

  @Test
  void whatIsNotFinishedIsNotBlamedOnABracketThatNobodyTyped() {
    assertEquals(
        "unexpected end of the expression: expected a value",
        guest(PROGRAM, 8, "count >").problem().orElseThrow().message());
    assertEquals(
        "unexpected `)`: expected a value",
        guest(PROGRAM, 8, "weigh(2 + )").problem().orElseThrow().message());
  }

  @Test
  void faultsOfTheTextAroundAreNotItsOwn() {
    String broken = PROGRAM.replace("weigh(1)", "unknown(1)");
    assertTrue(guest(broken, 5, "doubled > 4").problem().isEmpty());
  }

  @Test
  void completionsAreThoseOfTheLine() {
    List<String> inside =
        guest(PROGRAM, 5, "doub").completions(4).stream().map(Completion::label).toList();
    assertEquals("doubled", inside.getFirst());
  }
}
