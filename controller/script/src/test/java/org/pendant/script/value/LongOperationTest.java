package org.pendant.script.value;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.language.syntax.Expression.BinaryOperator;

/** What continues in the next frame works on the values of the frame in which it began. */
class LongOperationTest {
  private static final int MANY = 4 * LongOperation.PIECE;

  private static NumberList ones(int count) {
    double[] elements = new double[count];
    Arrays.fill(elements, 1);
    return NumberList.owning(elements, count, ValueKind.INT);
  }

  private static ObjectList texts(int count) {
    Value[] elements = new Value[count];
    Arrays.fill(elements, new StringValue("a"));
    return ObjectList.owning(elements, count, new StringValue("a"));
  }

  private static MatrixValue matrix(int rows, int columns) {
    double[] elements = new double[rows * columns];
    Arrays.fill(elements, 1);
    return MatrixValue.owning(rows, columns, elements, true);
  }

  private static StructValue struct(Value... members) {
    return StructValue.owning(List.of("a", "b").subList(0, members.length), members);
  }

  /** Begins, has something changed that was not looked at yet, and continues to the end. */
  private static Value interrupted(LongOperation operation, Change change) throws ScriptError {
    operation.advance();
    assertFalse(operation.done(), "it was over before anything could change");
    operation.keep();
    change.run();
    return LongOperation.finish(operation);
  }

  private interface Change {
    void run() throws ScriptError;
  }

  @Test
  void comparedNumbersAreThoseOfTheBeginning() throws ScriptError {
    NumberList left = ones(MANY);
    NumberList right = ones(MANY);
    LongOperation equal = Operators.beginEqual(left, right);
    assertEquals(BoolValue.TRUE, interrupted(equal, () -> left.set(MANY - 1, Value.of(2))));
  }

  @Test
  void comparedObjectsAreThoseOfTheBeginning() throws ScriptError {
    ObjectList left = texts(MANY / 8);
    ObjectList right = texts(MANY / 8);
    LongOperation equal = Operators.beginEqual(left, right);
    assertEquals(
        BoolValue.TRUE,
        interrupted(equal, () -> right.set(MANY / 8 - 1, new StringValue("other"))));
  }

  @Test
  void comparedMembersAreThoseOfTheBeginning() throws ScriptError {
    StructValue left = struct(ones(MANY), texts(1000));
    StructValue right = struct(ones(MANY), texts(1000));
    LongOperation equal = Operators.beginEqual(left, right);
    assertEquals(
        BoolValue.TRUE,
        interrupted(equal, () -> ((ObjectList) left.open("b")).set(999, new StringValue("other"))));
  }

  @Test
  void comparedElementsOfElementsAreThoseOfTheBeginning() throws ScriptError {
    StructValue[] parts = new StructValue[8];
    Arrays.setAll(parts, i -> struct(ones(LongOperation.PIECE)));
    ObjectList left = ObjectList.owning(parts, parts.length, parts[0].copy());
    ObjectList right = ObjectList.owning(parts.clone(), parts.length, parts[0].copy());
    LongOperation equal = Operators.beginEqual(left, right);
    assertEquals(
        BoolValue.TRUE,
        interrupted(
            equal, () -> ((ListValue) ((StructValue) left.open(7)).open("a")).set(3, Value.of(5))));
  }

  @Test
  void comparisonThatTakesSeveralPiecesFindsDifferences() throws ScriptError {
    NumberList other = ones(MANY);
    other.set(MANY - 1, Value.of(2));
    assertEquals(BoolValue.FALSE, LongOperation.finish(Operators.beginEqual(ones(MANY), other)));
  }

  @Test
  void numbersAreComparedPieceByPiece() throws ScriptError {
    LongOperation equal = Operators.beginEqual(ones(MANY), ones(MANY));
    int pieces = 0;
    while (!equal.done()) {
      assertTrue(equal.advance() >= LongOperation.PIECE / 2, "work was not counted");
      pieces++;
    }
    assertTrue(pieces >= 4, "in " + pieces + " pieces");
  }

  @Test
  void addedNumbersAreThoseOfTheBeginning() throws ScriptError {
    NumberList left = ones(MANY);
    NumberList right = ones(MANY);
    LongOperation sum = Operators.begin(BinaryOperator.ADD, left, right);
    NumberList result = (NumberList) interrupted(sum, () -> right.set(MANY - 1, Value.of(9)));
    assertEquals(2, result.numberAt(MANY - 1));
  }

  @Test
  void multipliedMatricesAreThoseOfTheBeginning() throws ScriptError {
    int rows = LongOperation.PIECE / 2;
    MatrixValue left = matrix(rows, 6);
    MatrixValue right = matrix(6, 6);
    LongOperation product = Operators.begin(BinaryOperator.MULTIPLY, left, right);
    MatrixValue result = (MatrixValue) interrupted(product, () -> right.set(5, 5, 100, true));
    assertEquals(6, result.get(rows - 1, 5));
  }

  @Test
  void rowsOfMatrixAreThoseOfTheBeginning() throws ScriptError {
    NumberList[] rows = new NumberList[LongOperation.PIECE / 4];
    Arrays.setAll(rows, i -> ones(8));
    LongOperation made = Operators.beginMatrix(rows);
    MatrixValue result =
        (MatrixValue) interrupted(made, () -> rows[rows.length - 1].set(0, Value.of(7)));
    assertEquals(1, result.get(rows.length - 1, 0));
  }

  @Test
  void listTimesMatrixIsComputedPieceByPiece() throws ScriptError {
    int rows = LongOperation.PIECE;
    NumberList factors = ones(16);
    LongOperation product = Operators.begin(BinaryOperator.MULTIPLY, matrix(rows, 16), factors);
    NumberList result = (NumberList) interrupted(product, () -> factors.set(0, Value.of(100)));
    assertEquals(16, result.numberAt(rows - 1));
  }
}
