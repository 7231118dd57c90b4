package org.pendant.controller.builtin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.pendant.controller.builtin.Refusals.refuses;
import static org.pendant.script.value.Make.bools;
import static org.pendant.script.value.Make.floats;
import static org.pendant.script.value.Make.ints;
import static org.pendant.script.value.Make.matrix;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.language.signature.Type;
import org.pendant.language.syntax.Expression.BinaryOperator;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.Operators;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

class MatrixBuiltinsTest {
  private final CallFixture fixture = new CallFixture();

  @Test
  void aMatrixHasAnInverse() throws ScriptError {
    assertEquals(
        matrix(ints(0, 0, 1), ints(1, 0, 0), ints(0, 1, 0)),
        fixture.call("inv", matrix(ints(0, 1, 0), ints(0, 0, 1), ints(1, 0, 0))));
    assertEquals("[[0.5]]", fixture.call("inv", matrix(ints(2))).text());
  }

  @Test
  void aSingularOrOblongMatrixHasNoInverse() throws ScriptError {
    MatrixValue rankOne = matrix(ints(1, 2), ints(2, 4));
    MatrixValue rankTwo = matrix(ints(1, 2, 3), ints(4, 5, 6), ints(7, 8, 9));
    MatrixValue zero = matrix(ints(0));
    MatrixValue oblong = matrix(ints(1, 2));
    refuses("matrix-singular", "no inverse", () -> fixture.call("inv", rankOne));
    refuses("matrix-singular", "no inverse", () -> fixture.call("inv", rankTwo));
    refuses("matrix-singular", "no inverse", () -> fixture.call("inv", zero));
    refuses("wrong-length", "must be square", () -> fixture.call("inv", oblong));
    refuses("wrong-type", "m is list", () -> fixture.call("inv", ints(1, 2)));
  }

  @Test
  void smallButRegularMatricesAreInvertible() throws ScriptError {
    MatrixValue tiny = matrix(floats(1e-9, 0), floats(0, 2e-9));
    assertEquals("[[1000000000, 0], [0, 500000000]]", fixture.call("inv", tiny).text());
  }

  @Test
  void anInverseTimesItsMatrixIsTheIdentity() throws ScriptError {
    SplittableRandom random = new SplittableRandom(5);
    for (int round = 0; round < 300; round++) {
      int size = 1 + random.nextInt(6);
      double[] elements = random.doubles((long) size * size, -1, 1).toArray();
      for (int i = 0; i < size; i++) {
        elements[i * size + i] += 3;
      }
      MatrixValue m = MatrixValue.owning(size, size, elements, false);
      Value product = Operators.binary(BinaryOperator.MULTIPLY, fixture.call("inv", m), m);
      for (int i = 0; i < size * size; i++) {
        double expected = i % (size + 1) == 0 ? 1 : 0;
        assertEquals(expected, ((MatrixValue) product).numberAt(i), 1e-10, m::text);
      }
    }
  }

  @Test
  void transposingExchangesRowsAndColumns() throws ScriptError {
    assertEquals(
        matrix(ints(1, 3, 5), ints(2, 4, 6)),
        fixture.call("transpose", matrix(ints(1, 2), ints(3, 4), ints(5, 6))));
    assertEquals(matrix(ints(1), ints(2), ints(3)), fixture.call("transpose", ints(1, 2, 3)));
    assertEquals(ints(1, 2, 3), fixture.call("transpose", matrix(ints(1), ints(2), ints(3))));
    assertEquals(
        "[[1], [2]]", fixture.call("transpose", matrix(ints(1, 2))).text().replace(".0", ""));
    refuses("wrong-type", "must be a matrix", () -> fixture.call("transpose", ints()));
    refuses("wrong-type", "must be a matrix", () -> fixture.call("transpose", bools(true)));
  }

  @Test
  void transposingLeavesTheArgumentAlone() throws ScriptError {
    NumberList list = ints(1, 2);
    MatrixValue column = (MatrixValue) fixture.call("transpose", list);
    column.set(0, 0, 9, true);
    assertEquals(ints(1, 2), list);
  }

  @Test
  void methodsAnswerRowsColumnsAndShape() throws ScriptError {
    MatrixValue m = matrix(ints(1, 2), ints(3, 4), ints(5, 6));
    assertEquals(ints(3, 4), fixture.method(Type.MATRIX, "get_row", m, 1));
    assertEquals(ints(2, 4, 6), fixture.method(Type.MATRIX, "get_column", m, 1));
    assertEquals(ints(3, 2), fixture.method(Type.MATRIX, "shape", m));
    assertEquals(Value.of("[[1, 2], [3, 4], [5, 6]]"), fixture.method(Type.MATRIX, "to_string", m));
    refuses(
        "value-out-of-range",
        "get_row: index is 3, must be 0 to 2",
        () -> fixture.method(Type.MATRIX, "get_row", m, 3));
    refuses(
        "value-out-of-range",
        "get_column: index is -1, must be 0 to 1",
        () -> fixture.method(Type.MATRIX, "get_column", m, -1));
  }

  @Test
  void rowsAreCopies() throws ScriptError {
    MatrixValue m = matrix(ints(1, 2));
    ((NumberList) fixture.method(Type.MATRIX, "get_row", m, 0)).setNumberAt(0, 9);
    assertEquals(matrix(ints(1, 2)), m);
  }
}
