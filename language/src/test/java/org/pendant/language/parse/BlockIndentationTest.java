package org.pendant.language.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.Source;

/** Which end is missing or too many, as the indentation says, slips elsewhere or not. */
final class BlockIndentationTest {
  /** A function with slips in its indentation, and right. */
  private static final String SLOPPY =
      """
      def sloppy():
          if a:
            while b:
              f()
           end
         else:
         if c:
          g()
       end
          end
        end
      """;

  @Test
  void rightBlocksMayStandAnywhere() {
    assertFaults(List.of(), SLOPPY);
    // Another mistake does not make them wrong.
    assertFaults(List.of("12: unexpected `=`: a statement assigns once"), SLOPPY + "x = 1 = 2\n");
  }

  @Test
  void aMissingEndIsFoundInTheFunctionThatLacksIt() {
    assertFaults(
        List.of(
            "14: `while` on line 14 has no `end`: by its indentation line 16 is outside of its"
                + " block"),
        SLOPPY
            + """
            def g():
              x = 1
              while x < 3:
                x = x + 1
              y = x
            end
            """
            + SLOPPY);
  }

  @Test
  void aMissingEndIsFoundInAFunctionInsideTheProgram() {
    assertFaults(
        List.of("3: `if` on line 3 has no `end`: the `end` on line 5 belongs to an outer block"),
        """
        def prog():
          def f():
            if a:
              g()
          end
          def h():
            if a:
              g()
             end
          end
          f()
        end
        """);
  }

  @Test
  void aFunctionWithoutItsEndIsNamedWhereTheNextOneBegins() {
    assertFaults(
        List.of(
            "1: `def` on line 1 has no `end`: by its indentation line 3 is outside of its block"),
        "def f():\n  x = 1\ndef g():\n  if a:\n  y = 1\n    end\nend\ndef h():\n  z = 1\nend\n");
  }

  @Test
  void anEndIsMissingBetweenTwoBlocksBesideEachOther() {
    assertFaults(
        List.of(
            "2: `if` on line 2 has no `end`: by its indentation line 4 is outside of its block"),
        "def f():\n  if a:\n    g()\n  if b:\n    g()\n  end\nend\n");
  }

  @Test
  void severalFunctionsMayLackAnEnd() {
    assertFaults(
        List.of(
            "2: `if` on line 2 has no `end`: the `end` on line 4 belongs to an outer block",
            "6: `while` on line 6 has no `end`: the `end` on line 8 belongs to an outer block"),
        "def f():\n  if a:\n    g()\nend\ndef h():\n  while b:\n    g()\nend\n" + SLOPPY);
  }

  @Test
  void aSurplusEndIsFoundInTheFunctionThatHasIt() {
    assertFaults(
        List.of("16: this `end` closes nothing: the `def` on line 12 has its `end` on line 18"),
        SLOPPY
            + """
            def g():
              if a:
                f()
              end
              end
              y = 1
            end
            """
            + SLOPPY);
  }

  @Test
  void aSurplusEndBehindAFunctionInsideTheProgramIsFound() {
    assertFaults(
        List.of("5: this `end` closes nothing: the `def` on line 1 has its `end` on line 10"),
        """
        def prog():
          def f():
            x = 1
          end
          end
          def g():
            x = 1
          end
          f()
        end
        """);
  }

  @Test
  void oneEndTooManyAndOneTooFewAreTwoFaults() {
    assertFaults(
        List.of(
            "4: this `end` closes nothing: every block before it has its `end` already",
            "6: `while` on line 6 has no `end`: the `end` on line 8 belongs to an outer block"),
        "def f():\n  g()\nend\nend\ndef h():\n  while b:\n    g()\nend\n");
  }

  @Test
  void withoutIndentationTheCountDecides() {
    assertFaults(
        List.of("1: `def` on line 1 has no `end`: the text ends inside its block"),
        "def f():\nif a:\ng()\nend\nx = 1\n");
    assertFaults(
        List.of("5: this `end` closes nothing: every block before it has its `end` already"),
        "def f():\nif a:\nend\nend\nend\n");
  }

  @Test
  void anElseKeepsItsIf() {
    assertFaults(
        List.of(
            "3: `while` on line 3 has no `end`: the `else` on line 5 belongs to an outer block"),
        "def f():\n  if a:\n    while b:\n      g()\n  else:\n    g()\n  end\nend\n");
  }

  @Test
  void anElseBehindASurplusEndBelongsToItsIf() {
    assertFaults(
        List.of("4: this `end` closes nothing: the `if` on line 2 has its `end` on line 7"),
        "def f():\n  if a:\n    g()\n  end\n  else:\n    g()\n  end\nend\n");
  }

  @Test
  void anIfHasOneElse() {
    assertFaults(
        List.of("3: `if` on line 3 has no `end`: the `else` on line 7 belongs to an outer block"),
        "def f():\n  if a:\n  if b:\n  g()\n  else:\n  g()\n  else:\n    g()\n  end\nend\n");
  }

  @Test
  void functionsInsideALoopAreIndentedLikeAnyBlock() {
    assertFaults(
        List.of("8: `if` on line 8 has no `end`: the `end` on line 10 belongs to an outer block"),
        """
        def prog():
          while True:
            def f():
              g()
            end
            f()
            while a:
              if b:
                g()
            end
            f()
          end
        end
        """);
  }

  private static void assertFaults(List<String> expected, String text) {
    Source source = Source.of("s", text);
    assertEquals(
        expected,
        ScriptParser.parseProgram(source).diagnostics().stream()
            .map(each -> source.line(each.range().start()) + ": " + each.message())
            .toList());
  }
}
