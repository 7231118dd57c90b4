package org.pendant.language.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;

class SyntaxErrorTest {

  /** The 51st error ends the reading; what is half read then is no statement. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "def a\u00b7b():\n y = 1\nend",
        "def a(",
        "thread a\u00b7b():\nend",
        "if a\u00b7b:\n y = 1\nend",
        "if a:\n y = 1\nelif a\u00b7b:\n y = 1\nend",
        "while a\u00b7b:\n y = 1\nend",
        "if a\n y = 1\nend",
        "x = (1"
      })
  void errorsBeyondTheLimitMayStandAnywhere(String last) {
    for (int before = 47; before <= 52; before++) {
      String text = "def f():\n" + "  x = 1 \u00b7\n".repeat(before) + last + "\nend\n";
      List<Diagnostic> errors = ScriptParser.parseProgram(Source.of("s", text)).diagnostics();
      assertTrue(errors.size() >= Math.min(before, 51) && errors.size() <= 51, "" + errors.size());
    }
  }

  @Test
  void saysWhereTheControllerGivesUpOnMissingColon() {
    Source source = Source.of("s", "def silly()\nend\n");
    Diagnostic error = only(source);
    assertEquals("syntax_error_on_line:2:end:", error.wireText());
    assertEquals(2, source.line(error.range().start()));
    assertEquals(1, source.column(error.range().start()));
    assertTrue(error.message().contains("missing `:`"), error.message());
  }

  @Test
  void saysWhereTheControllerGivesUpOnUnclosedBracket() {
    Source source = Source.of("s", "def f():\n  movej([0,1], a=1\nend\n");
    Diagnostic error = only(source);
    assertEquals("syntax_error_on_line:3:end:", error.wireText());
    assertEquals("`(` at 2:8 is not closed: found `end`, expected `)`", error.message());
  }

  @Test
  void reportsEveryIndependentErrorOnce() {
    assertErrors(
        "2:syntax-error 4:missing-colon 8:syntax-error 10:arithmetic-assign",
        """
        def f():
          a = 1 2
          while a > 1
            g()
          end
          b = [1, 2,
               3]
          c = g(1, , 2)
          d = 4
          d += 1
        end
        """);
  }

  @Test
  void skipsRestOfBrokenListInOnePiece() {
    assertErrors(
        "1:syntax-error 4:syntax-error",
        """
        x = [1, 2 3,
          a, b,
          4]
        y = )
        z = 1
        """);
  }

  @Test
  void keepsStatementsAroundErrors() {
    ParseResult result =
        ScriptParser.parseProgram(Source.of("s", "def f():\n a = 1\n b = = 2\n c = 3\nend\nd = 4"));
    assertEquals(
        "{(FUNCTION f[]{(set FREE a 1) (set FREE c 3)}) (set FREE d 4)}",
        TreeShape.of(result.script()));
  }

  @Test
  void keepsBlockWhoseConditionIsBroken() {
    ParseResult result =
        ScriptParser.parseProgram(Source.of("s", "if a = 1:\n f()\nelse:\n g()\nend\n"));
    assertEquals(List.of("syntax-error"), codes(result));
    assertEquals("{(if a{(do f())} else {(do g())})}", TreeShape.of(result.script()));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '~',
      value = {
        "x = 1;                 ~ semicolon         ~ `;` is not needed",
        "x = 'text'             ~ single-quotes     ~ `\"text\"`",
        "x = \"text             ~ unclosed-string   ~ the string is not closed",
        "x += 1                 ~ arithmetic-assign ~ `x = x + ...`",
        "x++                    ~ syntax-error      ~ `x = x + 1`",
        "x := 1                 ~ colon-assign      ~ `=`",
        "x = a && b             ~ and-sign          ~ `and`",
        "x = a || b             ~ or-sign           ~ `or`",
        "x = a <> b             ~ unequal-sign      ~ `!=`",
        "// text                ~ comment           ~ `#`",
        "x == 1                 ~ syntax-error      ~ assign with `=`",
        "if x = 1: end          ~ syntax-error      ~ compare with `==`",
        "while f(x = 1: end     ~ syntax-error      ~ `(` at 1:8 is not closed",
        "f(a.b = 1)             ~ argument-name     ~ `a.b` is not a name",
        "x = 0x1F               ~ no-effect         ~ hexadecimal",
        "f(0x1F)                ~ syntax-error      ~ hexadecimal",
        "x.y                    ~ no-effect         ~ `x.y(...)`",
        "x = 2.7358E-           ~ syntax-error      ~ `2.7358E-` is not finished: its exponent",
        "x = [1, 2.7358E-, 3]   ~ syntax-error      ~ `2.7358E-` is not finished: its exponent",
        "f(.5e+)                ~ syntax-error      ~ `.5e+` is not finished: its exponent",
        "x = 2E                 ~ no-effect         ~ `2E` is not finished: its exponent",
        "x = p[1,2,3]           ~ pose-elements     ~ pose with 3 elements",
        "x = a[1,2,3]           ~ index-count       ~ 3 indices",
        "x = a[]                ~ index-count       ~ 0 indices",
        "a[1]                   ~ no-effect         ~ own: expected `a[1] = ...`",
        "p[1, 2, 3, 4, 5, 6]    ~ no-effect         ~ own: expected a variable that it is",
        "p[1, 2, 3]             ~ pose-elements     ~ pose with 3 elements",
        "x = 5 p[1, 2, 3]       ~ pose-elements     ~ pose with 3 elements",
        "p[1, 2, 3] = 5         ~ pose-elements     ~ pose with 3 elements",
        "f(x) = 1               ~ assignment-target ~ cannot be assigned",
        "f(1))                  ~ syntax-error      ~ `)` closes nothing",
        "x = f(1]               ~ syntax-error      ~ closes with `)`",
        "x = @                  ~ syntax-error      ~ `@` has no meaning",
        "x = 1 $ 2 \"l\"        ~ syntax-error      ~ line of its own",
        "x = \"a\\\"b\\\"\"     ~ syntax-error      ~ no escapes",
        "global x               ~ syntax-error      ~ expected `=`",
        "run t                  ~ syntax-error      ~ `run t()`",
        "thread t(a): end       ~ thread-parameters ~ takes none",
        "def f: end             ~ syntax-error      ~ missing `()`",
        "def f(): } end         ~ syntax-error      ~ close with `end`",
        "for i in x: end        ~ unknown-block     ~ loop with `while`",
        "wile x: end            ~ unknown-block     ~ a block opens with",
        "While x: end           ~ word-case         ~ lower case",
        "function f(): end      ~ function-word     ~ `def`",
        "end                    ~ stray-end         ~ closes nothing",
        "else: f()              ~ stray-else        ~ belongs to no `if`",
        "if a: f()              ~ missing-end       ~ `if` on line 1 has no `end`",
        "f()()                  ~ syntax-error      ~ only a function",
        "x = 1 +                ~ syntax-error      ~ expected a value",
        "x = 1 +                ~ syntax-error      ~ unexpected the end of the text: expected a"
            + " value behind `+`",
        "x = f(1 2)             ~ syntax-error      ~ expected an operator, `,` or `)` for `(` at"
            + " 1:6",
        "x = f(, 2)             ~ syntax-error      ~ unexpected `,`: expected a value",
        "global = 1             ~ syntax-error      ~ expected a variable name behind `global`",
        "run 1                  ~ syntax-error      ~ expected the name of a thread, `run name()`",
        "x = a. + 1             ~ syntax-error      ~ expected the name of a member or a method",
        "if : end               ~ syntax-error      ~ the condition is missing in front of `:`",
        "if a b: end            ~ missing-colon     ~ found `b`",
        "x = 1 = 2              ~ syntax-error      ~ a statement assigns once",
        "x = 1 ,                ~ syntax-error      ~ unexpected `,` behind `1`: expected a"
            + " statement",
        ", x                    ~ syntax-error      ~ unexpected `,`: expected a statement",
        "switch x: end          ~ unknown-block     ~ write `if`, `elif` and `else`",
        "try x: end             ~ unknown-block     ~ errors cannot be caught",
        "x = \\ 1               ~ syntax-error      ~ does not continue a line",
      })
  void explainsTypicalMistakes(String line, String code, String part) {
    Diagnostic error = only(Source.of("s", line));
    assertEquals(code, error.code());
    assertTrue(error.message().contains(part), error.message());
    assertTrue(error.wireText().startsWith("syntax_error_on_line:1:"), error.wireText());
  }

  @Test
  void namesTheLineOfAHeadThatLacksItsColon() {
    assertEquals(
        "missing `:` behind the head of `while`: found `a`",
        only(Source.of("s", "while True a = 1 end")).message());
    assertEquals(
        "missing `:` behind the head of `while` on line 1: found `a`",
        only(Source.of("s", "while True\n a = 1\nend")).message());
  }

  @Test
  void saysToWhichBlockAnEndMayBelong() {
    assertEquals(
        "this `end` closes nothing: every block before it has its `end` already",
        only(Source.of("s", "x = 1\nend\n")).message());
    assertEquals(
        "this `end` closes nothing: the `def` on line 1 has its `end` on line 5",
        only(Source.of("s", "def f():\n  x = 1\n  end\n  y = 2\nend\n")).message());
  }

  @Test
  void leavesUnknownNamesToTheChecker() {
    assertTrue(ScriptParser.parseProgram(Source.of("s", "x = true\ny = null\nelseif = 1")).ok());
  }

  @Test
  void mendsElseIf() {
    assertErrors(
        "3:else-if 5:else-if",
        """
        if a:
          f()
        else if b:
          g()
        elseif c:
          h()
        end
        """);
  }

  @Test
  void doesNotCascadeFromUnclosedStringInsideHead() {
    assertErrors(
        "1:unclosed-string",
        """
        if f("text) == g([1, 2]):
          h()
        end
        """);
  }

  @Test
  void namesTheBlockThatLacksItsEnd() {
    Source source =
        Source.of("s", "def f():\n  while True:\n    sync()\nend\ndef g():\n  x = 1\nend\n");
    Diagnostic error = only(source);
    assertEquals("missing-end", error.code());
    assertEquals("while", source.text(error.range()));
    assertEquals(
        "`while` on line 2 has no `end`: the `end` on line 4 belongs to an outer block",
        error.message());
    assertEquals("syntax_error_on_line:7:end:", error.wireText());
  }

  @Test
  void namesTheBlockThatLacksItsEndBeforeElse() {
    assertErrors(
        "2:missing-end",
        """
        if a:
          while b:
            f()
        else:
          g()
        end
        """);
  }

  @Test
  void findsTheSuperfluousEndByItsIndentation() {
    assertErrors(
        "3:stray-end",
        """
        def f():
          x = 1
          end
          y = 2
        end
        """);
  }

  @Test
  void reportsErrorInsideUnclosedBlockToo() {
    assertErrors("1:missing-end 2:syntax-error", "def f():\n  x = )\n");
  }

  @Test
  void takesAtMostFiftyErrors() {
    ParseResult result = ScriptParser.parseProgram(Source.of("s", "x = )\n".repeat(1000)));
    assertEquals(51, result.diagnostics().size());
    assertEquals("too-many-errors", result.diagnostics().getLast().code());
  }

  @Test
  void reportsAtMostOneErrorForALine() {
    assertErrors("1:syntax-error 2:semicolon", "x = ) + ]\nx = 1;;;\n");
  }

  private static void assertErrors(String expected, String text) {
    Source source = Source.of("s", text);
    ParseResult result = ScriptParser.parseProgram(source);
    assertEquals(
        expected,
        result.diagnostics().stream()
            .map(error -> source.line(error.range().start()) + ":" + error.code())
            .collect(Collectors.joining(" ")),
        () -> result.diagnostics().toString());
  }

  private static Diagnostic only(Source source) {
    ParseResult result = ScriptParser.parseProgram(source);
    assertFalse(result.ok());
    assertEquals(1, result.diagnostics().size(), () -> result.diagnostics().toString());
    return result.diagnostics().getFirst();
  }

  private static List<String> codes(ParseResult result) {
    return result.diagnostics().stream().map(Diagnostic::code).toList();
  }
}
