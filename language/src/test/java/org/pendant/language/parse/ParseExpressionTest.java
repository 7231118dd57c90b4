package org.pendant.language.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.language.source.Source;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Statement;

class ParseExpressionTest {

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "1+2-3                     | ((1 + 2) - 3)",
        "4*5/6                     | ((4 * 5) / 6)",
        "(1+2)*3/(4-5)             | (((1 + 2) * 3) / (4 - 5))",
        "2346.44 % 10              | (2346.44 % 10)",
        "True or False and (1 == 2) | (True or (False and (1 == 2)))",
        "1 > 2 or 3 != 4 xor 5 < -6 | (((1 > 2) or (3 != 4)) xor (5 < (- 6)))",
        "not 42 >= 87 and 87 <= 42 | ((not (42 >= 87)) and (87 <= 42))",
        "not expected == result    | (not (expected == result))",
        "! camera.initialize()     | (not <camera>.initialize())",
        "not not a                 | (not (not a))",
        "a == not b                | (a == (not b))",
        "a and not b == c and d    | ((a and (not (b == c))) and d)",
        "a + not b + c             | ((a + (not b)) + c)",
        "r * -sin(x)               | (r * (- sin(x)))",
        "-x * y                    | ((- x) * y)",
        "-x.y[1]                   | (- <<x>.y>[1])",
        "a - -1                    | (a - (- 1))",
        "+1                        | (+ 1)",
        "a < b < c                 | ((a < b) < c)",
        "[1,2,3] * [10,20,30]      | ([1, 2, 3] * [10, 20, 30])",
        "(False)xor(x)             | (False xor x)",
        "5and b                    | (5 and b)",
      })
  void bindsOperatorsByPrecedence(String text, String shape) {
    assertEquals(shape, TreeShape.of(parse(text)));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "0 | 0",
        "007 | 7",
        "2147483647 | 2147483647",
        "-2147483648 | -2147483648",
        "1.5 | 1.5",
        "3. | 3.0",
        ".5 | 0.5",
        "1e-6 | 1.0E-6",
        "8.5E-16 | 8.5E-16",
        "2.e3 | 2000.0",
        "True | True",
        "None | None",
        "true | true",
        "[] | []",
        "[[1,2],[3,4]] | [[1, 2], [3, 4]]",
        "p[1,2,3,4,5,6] | p[1, 2, 3, 4, 5, 6]",
        "p[0.1*i,0,0,0,0,d2r(90)][2] | <p[(0.1 * i), 0, 0, 0, 0, d2r(90)]>[2]",
        "p[0] | <p>[0]",
        "p[i,j] | <p>[i, j]",
        "p | p",
        "state.p[0] | <<state>.p>[0]",
        "struct(p = p[0,0,0,0,0,0], v = 1) | struct(p=p[0, 0, 0, 0, 0, 0], v=1)",
      })
  void readsLiterals(String text, String shape) {
    assertEquals(shape, TreeShape.of(parse(text)));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "f() | f()",
        "movej(q, a=1.4, v = 1.05) | movej(q, a=1.4, v=1.05)",
        "time().sec | <time()>.sec",
        "get_circle_pos(t).p | <get_circle_pos(t)>.p",
        "h.server.getTCP(id) | <<h>.server>.getTCP(id)",
        "server.run() | <server>.run()",
        "m[2,1] | <m>[2, 1]",
        "aa[4].p1 | <<aa>[4]>.p1",
        "x[i][j] | <<x>[i]>[j]",
        "f(x)[0].g(1).h | <<<f(x)>[0]>.g(1)>.h",
        "[1,2].length() | <[1, 2]>.length()",
        "(a + b).to_string() | <(a + b)>.to_string()",
        "run t() | (run t())",
        "f(run t(), g(1)) | f((run t()), g(1))",
      })
  void readsCallsMembersAndIndices(String text, String shape) {
    assertEquals(shape, TreeShape.of(parse(text)));
  }

  @Test
  void keepsEveryByteOfString() {
    byte[] bytes = {'x', '=', '"', '\\', (byte) 0xC3, (byte) 0xA9, '\t', '#', '\'', '"'};
    Statement.Assign assign =
        (Statement.Assign)
            ScriptParser.parseProgram(Source.of("s", bytes)).script().statements().getFirst();
    Expression.StringLiteral string =
        assertInstanceOf(Expression.StringLiteral.class, assign.value());
    assertEquals("\\\u00C3\u00A9\t#'", string.value());
  }

  @ParameterizedTest
  @CsvSource({
    "1 + 2 * 3, 1 + 2 * 3",
    "(a + b) * c, (a + b) * c",
    "a * (b + c), a * (b + c)",
    "-(a), -(a)",
    "not  a, not  a",
    "(a).b, (a).b",
    "f( 1 ).g ( ), f( 1 ).g ( )",
    "((a)) == ((b)), ((a)) == ((b))",
  })
  void coversWholeExpressionWithItsRange(String text, String covered) {
    Source source = Source.of("s", "x = " + text + "   # end\n");
    Statement.Assign assign =
        (Statement.Assign) ScriptParser.parseProgram(source).script().statements().getFirst();
    assertEquals(covered, source.text(assign.value().range()));
  }

  @Test
  void givesExactRangesInsideCall() {
    Source source = Source.of("s", "x = a.move( [1, 2 ] , speed = -v )[ 0 ]\n");
    Statement.Assign assign =
        (Statement.Assign) ScriptParser.parseProgram(source).script().statements().getFirst();
    Expression.Index index = assertInstanceOf(Expression.Index.class, assign.value());
    Expression.MethodCall call = assertInstanceOf(Expression.MethodCall.class, index.receiver());
    assertEquals("a.move( [1, 2 ] , speed = -v )[ 0 ]", source.text(index.range()));
    assertEquals("a.move( [1, 2 ] , speed = -v )", source.text(call.range()));
    assertEquals("move", source.text(call.nameRange()));
    assertEquals("a", source.text(call.receiver().range()));
    assertEquals("[1, 2 ]", source.text(call.arguments().get(0).range()));
    assertEquals("speed = -v", source.text(call.arguments().get(1).range()));
    assertEquals("-v", source.text(call.arguments().get(1).value().range()));
    assertEquals("0", source.text(index.indices().getFirst().range()));
  }

  private static Expression parse(String text) {
    ParseResult result = ScriptParser.parseProgram(Source.of("test", "x = " + text));
    assertTrue(result.ok(), () -> text + ": " + result.diagnostics());
    assertEquals(1, result.script().statements().size(), text);
    return ((Statement.Assign) result.script().statements().getFirst()).value();
  }
}
