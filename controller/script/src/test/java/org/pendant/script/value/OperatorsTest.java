package org.pendant.script.value;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.script.value.Make.bools;
import static org.pendant.script.value.Make.floats;
import static org.pendant.script.value.Make.ints;
import static org.pendant.script.value.Make.list;
import static org.pendant.script.value.Make.matrix;
import static org.pendant.script.value.Make.pose;
import static org.pendant.script.value.Make.strings;
import static org.pendant.script.value.Make.struct;
import static org.pendant.script.value.Make.value;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.language.syntax.Expression.BinaryOperator;

class OperatorsTest {
  private static Value compute(Object left, String operator, Object right) throws ScriptError {
    for (BinaryOperator candidate : BinaryOperator.values()) {
      if (candidate.text().equals(operator)) {
        return Operators.binary(candidate, value(left), value(right));
      }
    }
    throw new IllegalArgumentException(operator);
  }

  private static void refuses(String code, String part, Object left, String op, Object right) {
    ScriptError error = assertThrows(ScriptError.class, () -> compute(left, op, right));
    assertEquals(code, error.code());
    assertTrue(error.getMessage().contains(part), error.getMessage());
  }

  @Test
  void intsStayIntsExceptInDivision() throws ScriptError {
    assertEquals(Value.of(5), compute(2, "+", 3));
    assertEquals(Value.of(-1), compute(2, "-", 3));
    assertEquals(Value.of(6), compute(2, "*", 3));
    assertEquals(Value.of(0.5), compute(1, "/", 2));
    assertEquals(Value.of(2.0), compute(4, "/", 2));
    assertEquals(Value.of(3.5), compute(2, "+", 1.5));
  }

  @Test
  void aRemainderHasTheSignOfTheDividend() throws ScriptError {
    assertEquals(Value.of(1), compute(7, "%", 3));
    assertEquals(Value.of(-1), compute(-7, "%", 3));
    assertEquals(Value.of(1), compute(7, "%", -3));
    assertEquals(Value.of(0), compute(-6, "%", 3));
    assertEquals(Value.of(-1.5), compute(-7.5, "%", 2));
    assertEquals(6.44, Operators.number(compute(2346.44, "%", 10)), 1e-9);
  }

  @Test
  void anIntResultThatDoesNotFitIsAnError() {
    refuses("integer-overflow", "2147483648", Integer.MAX_VALUE, "+", 1);
    refuses("integer-overflow", "-2147483649", Integer.MIN_VALUE, "-", 1);
    refuses("integer-overflow", "4294967296", 65536, "*", 65536);
    refuses("integer-overflow", "2147483648", ints(1, Integer.MAX_VALUE), "+", 1);
    assertThrows(ScriptError.class, () -> Operators.negate(Value.of(Integer.MIN_VALUE)));
  }

  @Test
  void dividingByZeroIsAnErrorEverywhere() throws ScriptError {
    refuses("division-by-zero", "divisor is 0", 1, "/", 0);
    refuses("division-by-zero", "divisor is 0", 1.5, "/", 0.0);
    refuses("division-by-zero", "divisor is 0", 5, "%", 0);
    refuses("division-by-zero", "divisor is 0", ints(1, 2), "/", ints(1, 0));
    refuses("division-by-zero", "divisor is 0", 1, "%", matrix(ints(1, 0)));
  }

  @Test
  void listsCombineElementByElement() throws ScriptError {
    assertEquals(ints(10, 40, 90), compute(ints(1, 2, 3), "*", ints(10, 20, 30)));
    assertEquals(floats(10, 10, 10), compute(ints(10, 20, 30), "/", ints(1, 2, 3)));
    assertEquals(ints(11, 22, 33), compute(ints(1, 2, 3), "+", ints(10, 20, 30)));
    assertEquals(ints(9, 18, 27), compute(ints(10, 20, 30), "-", ints(1, 2, 3)));
    assertEquals(ints(0, 0, 0), compute(ints(10, 20, 30), "%", ints(1, 2, 3)));
    assertEquals(ints(), compute(ints(), "+", ints()));
  }

  @Test
  void scalarsCombineWithEveryElement() throws ScriptError {
    assertEquals(ints(5, 10, 15), compute(ints(1, 2, 3), "*", 5));
    assertEquals(
        matrix(ints(5, 10), ints(15, 20)), compute(5, "*", matrix(ints(1, 2), ints(3, 4))));
    assertEquals(floats(1, 2, 3), compute(ints(10, 20, 30), "/", 10));
    assertEquals(floats(1, 0.5), compute(10, "/", ints(10, 20)));
    assertEquals(
        matrix(ints(-5, -15), ints(-25, -35)), compute(5, "-", matrix(ints(10, 20), ints(30, 40))));
    assertEquals(
        matrix(ints(1, 1), ints(1, 1)), compute(121, "%", matrix(ints(10, 20), ints(30, 40))));
  }

  @Test
  void resultsOfIntsAreIntsExceptOfDivision() throws ScriptError {
    assertEquals(ValueKind.INT, ((ListValue) compute(ints(1, 2), "*", 2)).elementKind());
    assertEquals(ValueKind.FLOAT, ((ListValue) compute(ints(1, 2), "*", 2.0)).elementKind());
    assertEquals(ValueKind.FLOAT, ((ListValue) compute(ints(2, 4), "/", 2)).elementKind());
    assertEquals(
        ValueKind.INT,
        ((MatrixValue) compute(matrix(ints(1)), "*", matrix(ints(2)))).elementKind());
    assertEquals(ValueKind.FLOAT, ((MatrixValue) compute(matrix(ints(1)), "/", 1)).elementKind());
  }

  @Test
  void listsOfDifferentLengthDoNotCombine() {
    refuses("wrong-length", "2 and 3 elements", ints(1, 2), "+", ints(1, 2, 3));
  }

  @Test
  void matricesMultiplyByRowsAndColumns() throws ScriptError {
    MatrixValue tall = matrix(ints(1, 2), ints(3, 4), ints(5, 6));
    MatrixValue wide = matrix(ints(10, 20, 30), ints(40, 50, 60));
    assertEquals(
        matrix(ints(90, 120, 150), ints(190, 260, 330), ints(290, 400, 510)),
        compute(tall, "*", wide));
    assertEquals(ints(50, 110, 170), compute(tall, "*", ints(10, 20)));
    refuses("wrong-length", "as many columns", tall, "*", tall);
    refuses("wrong-length", "one element a column", tall, "*", ints(1, 2, 3));
    refuses("wrong-type", "cannot combine", ints(1, 2), "*", wide);
  }

  @Test
  void matricesOfOneShapeAddAndSubtract() throws ScriptError {
    MatrixValue a = matrix(ints(1, 2), ints(3, 4));
    assertEquals(matrix(ints(2, 4), ints(6, 8)), compute(a, "+", a));
    assertEquals(matrix(ints(0, 0), ints(0, 0)), compute(a, "-", a));
    refuses("wrong-length", "2 x 2 matrix and a 1 x 2 matrix", a, "+", matrix(ints(1, 2)));
    refuses("wrong-type", "cannot combine", a, "/", a);
  }

  @Test
  void matrixProductsAreAssociative() throws ScriptError {
    SplittableRandom random = new SplittableRandom(11);
    for (int round = 0; round < 200; round++) {
      int n = 1 + random.nextInt(6);
      int m = 1 + random.nextInt(6);
      MatrixValue a = randomMatrix(random, n, m);
      MatrixValue b = randomMatrix(random, m, n);
      MatrixValue c = randomMatrix(random, n, m);
      MatrixValue left = (MatrixValue) compute(compute(a, "*", b), "*", c);
      MatrixValue right = (MatrixValue) compute(a, "*", compute(b, "*", c));
      for (int i = 0; i < n * m; i++) {
        assertEquals(left.numberAt(i), right.numberAt(i), 1e-12, () -> a + " " + b + " " + c);
      }
    }
  }

  private static MatrixValue randomMatrix(SplittableRandom random, int rows, int columns) {
    double[] elements = random.doubles((long) rows * columns, -1, 1).toArray();
    return MatrixValue.owning(rows, columns, elements, false);
  }

  @Test
  void stringsJoinOnlyWithStrings() throws ScriptError {
    assertEquals(Value.of("ab"), compute("a", "+", "b"));
    refuses("wrong-type", "to_str", "n is ", "+", 3);
    refuses("wrong-type", "cannot combine", "a", "*", 3);
    String half = "x".repeat(Operators.MAX_STRING_LENGTH / 2 + 1);
    refuses("string-too-long", "at most", half, "+", half);
  }

  @Test
  void posesAreNotArithmetic() {
    refuses("wrong-type", "pose_add", pose(1, 0, 0, 0, 0, 0), "+", pose(1, 0, 0, 0, 0, 0));
    refuses("wrong-type", "pose_trans", 2, "*", pose(1, 0, 0, 0, 0, 0));
  }

  @Test
  void boolsAndListsOfOthersAreNotArithmetic() throws ScriptError {
    refuses("wrong-type", "a bool", true, "+", 1);
    refuses("wrong-type", "list of 2 bool", bools(true, false), "+", 1);
    refuses("wrong-type", "list of 1 string", strings("a"), "+", strings("b"));
    refuses("wrong-type", "None", NoneValue.NONE, "+", 1);
  }

  @Test
  void membersOfOneTypeAreAddedToAListOfIt() throws ScriptError {
    StructValue numbers = struct("m1", 1.1, "m2", 2.2);
    assertEquals(floats(1.1, 2.2), compute(floats(0, 0), "+", numbers));
    assertEquals(floats(1.1, 2.2), compute(ints(), "+", numbers));
    assertEquals(strings("a", "b"), compute(strings("x"), "+", struct("p", "a", "q", "b")));
    refuses("wrong-type", "cannot combine", strings("x"), "+", numbers);
    refuses("wrong-type", "one type", floats(0, 0), "+", struct("a", "s", "b", 1));
    refuses("wrong-length", "elements", floats(0), "+", numbers);
  }

  @Test
  void negationKeepsTheKind() throws ScriptError {
    assertEquals(Value.of(-3), Operators.negate(Value.of(3)));
    assertEquals(Value.of(-0.5), Operators.negate(Value.of(0.5)));
    assertEquals(ints(-1, 2), Operators.negate(ints(1, -2)));
    assertEquals(matrix(ints(-1)), Operators.negate(matrix(ints(1))));
    assertThrows(ScriptError.class, () -> Operators.negate(Value.of("a")));
    assertThrows(ScriptError.class, () -> Operators.negate(pose(1, 2, 3, 0, 0, 0)));
  }

  @Test
  void onlyNumbersHaveAnOrder() throws ScriptError {
    assertEquals(Value.of(true), compute(1, "<", 1.5));
    assertEquals(Value.of(false), compute(2, "<", 2));
    assertEquals(Value.of(true), compute(2, "<=", 2));
    assertEquals(Value.of(true), compute(3, ">", 2));
    assertEquals(Value.of(true), compute(3, ">=", 3));
    assertEquals(Value.of(false), compute(Double.NaN, "<=", 1));
    refuses("wrong-type", "numbers", "a", "<", "b");
    refuses("wrong-type", "numbers", true, "<", 1);
  }

  @Test
  void logicTakesBoolsNumbersAndStrings() throws ScriptError {
    assertEquals(Value.of(true), compute(true, "xor", false));
    assertEquals(Value.of(false), compute(true, "xor", 1));
    assertEquals(Value.of(true), compute(0, "or", 2.5));
    assertEquals(Value.of(false), compute(true, "and", 0.0));
    assertEquals(Value.of(false), Operators.not(Value.of(1)));
    assertEquals(Value.of(true), compute(true, "and", "text"));
    assertEquals(Value.of(false), compute("", "or", ""));
    refuses("wrong-type", "must be a bool", true, "and", ints(1));
    assertThrows(ScriptError.class, () -> Operators.truth(ints(1)));
  }

  @Test
  void equalityIsByContent() throws ScriptError {
    assertTrue(Operators.equal(Value.of(1), Value.of(1.0)));
    assertFalse(Operators.equal(Value.of(0.3), Value.of(0.1 + 0.2)));
    assertTrue(Operators.equal(Value.of("a"), Value.of("a")));
    assertTrue(Operators.equal(ints(1, 2), floats(1, 2)));
    assertTrue(Operators.equal(floats(0.0), floats(-0.0)));
    assertFalse(Operators.equal(floats(Double.NaN), floats(Double.NaN)));
    assertFalse(Operators.equal(ints(1, 2), ints(1, 2, 3)));
    assertTrue(Operators.equal(Make.room(5), ints()));
    assertTrue(Operators.equal(pose(1, 2, 3, 4, 5, 6), pose(1, 2, 3, 4, 5, 6)));
    assertFalse(Operators.equal(pose(1, 2, 3, 4, 5, 6), pose(1, 2, 3, 4, 5, 7)));
    assertTrue(Operators.equal(struct("a", 1), struct("a", 1.0)));
    assertFalse(Operators.equal(struct("a", 1), struct("b", 1)));
    assertTrue(Operators.equal(list(struct("a", 1)), list(struct("a", 1.0))));
    assertTrue(Operators.equal(matrix(ints(1, 2)), matrix(floats(1, 2))));
    assertFalse(Operators.equal(matrix(ints(1, 2)), matrix(ints(1), ints(2))));
  }

  @Test
  void differentKindsAreNotEqualExceptBoolsAndTheNumbersOneAndZero() throws ScriptError {
    assertTrue(Operators.equal(Value.of(true), Value.of(1)));
    assertFalse(Operators.equal(Value.of(true), Value.of(2)));
    assertFalse(Operators.equal(Value.of("1"), Value.of(1)));
    assertFalse(Operators.equal(NoneValue.NONE, Value.of(0)));
    assertTrue(Operators.equal(NoneValue.NONE, NoneValue.NONE));
    assertFalse(Operators.equal(pose(1, 2, 3, 4, 5, 6), floats(1, 2, 3, 4, 5, 6)));
    assertFalse(Operators.equal(ints(1, 2), matrix(ints(1, 2))));
    assertFalse(Operators.equal(strings("a"), ints(1)));
    assertTrue(Operators.equal(strings(), ints()));
    assertEquals(Value.of(true), compute("a", "!=", 1));
  }

  @Test
  void aListLiteralTakesTheTypeOfItsElements() throws ScriptError {
    assertEquals(ValueKind.INT, ((ListValue) list(1, 2)).elementKind());
    assertEquals(ValueKind.FLOAT, ((ListValue) list(1, 2.5)).elementKind());
    assertEquals(ValueKind.BOOL, ((ListValue) list(true)).elementKind());
    assertEquals(ValueKind.STRING, ((ListValue) list("a", "b")).elementKind());
    assertEquals(0, ((ListValue) list()).capacity());
    assertEquals(3, ((ListValue) list(1, 2, 3)).capacity());
    assertEquals(floats(1, 2), Operators.listLiteral(List.of(Value.of(1), Value.of(2.0))));
  }

  @Test
  void aListLiteralOfListsIsAMatrix() throws ScriptError {
    MatrixValue matrix = (MatrixValue) list(ints(1, 2), floats(3, 4.5));
    assertEquals(2, matrix.rows());
    assertEquals(2, matrix.columns());
    assertFalse(matrix.integers());
    assertThrows(ScriptError.class, () -> list(ints(1, 2), ints(3)));
    assertThrows(ScriptError.class, () -> list(ints(1, 2), 3));
    assertThrows(ScriptError.class, () -> list(strings("a"), strings("b")));
    assertThrows(ScriptError.class, () -> list(ints(), ints()));
    assertThrows(ScriptError.class, () -> list(matrix(ints(1))));
  }

  @Test
  void aListLiteralOfMixedTypesIsAnError() {
    for (Object[] elements :
        List.of(
            new Object[] {1, "two"},
            new Object[] {"one", 2},
            new Object[] {true, 1},
            new Object[] {1, true},
            new Object[] {struct("a", 1), struct("b", 1)},
            new Object[] {NoneValue.NONE})) {
      ScriptError error = assertThrows(ScriptError.class, () -> list(elements));
      assertEquals("wrong-type", error.code());
    }
  }

  @Test
  void aListLiteralCopiesItsElements() throws ScriptError {
    StructValue original = struct("n", 1);
    ListValue list = (ListValue) list(original);
    original.set("n", Value.of(2));
    assertEquals(struct("n", 1), list.get(0));
  }

  @Test
  void registersMakeTheSameListsAsValues() throws ScriptError {
    Registers registers = new Registers(4);
    registers.setInt(1, 7);
    registers.setInt(2, 8);
    assertEquals(ValueKind.INT, ((ListValue) Operators.listLiteral(registers, 1, 2)).elementKind());
    registers.setFloat(2, 8.5);
    assertEquals(floats(7, 8.5), Operators.listLiteral(registers, 1, 2));
    registers.setBool(2, true);
    assertThrows(ScriptError.class, () -> Operators.listLiteral(registers, 1, 2));
    registers.set(1, Value.of("a"));
    assertEquals(strings("a"), Operators.listLiteral(registers, 1, 1));
  }
}
