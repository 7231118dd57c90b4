package org.pendant.controller.value;

import org.pendant.language.syntax.Expression.BinaryOperator;

/**
 * Arithmetic of lists and matrices of numbers (manual 5). Results of ints are ints, except those of
 * a division.
 */
final class Elementwise {
  private Elementwise() {}

  static Value apply(BinaryOperator operator, Value left, Value right) throws ScriptError {
    if (left instanceof MatrixValue a && right instanceof MatrixValue b) {
      return switch (operator) {
        case MULTIPLY -> product(a, b);
        case ADD, SUBTRACT -> sum(operator, a, b);
        default -> throw Operators.cannotCombine(operator, left, right);
      };
    }
    if (left instanceof MatrixValue a && numbers(right) && operator == BinaryOperator.MULTIPLY) {
      return product(a, (NumberList) right);
    }
    if (numbers(left) && numbers(right)) {
      return lists(operator, (NumberList) left, (NumberList) right);
    }
    if (left.kind().isNumber()) {
      return scalarFirst(operator, left, right);
    }
    if (right.kind().isNumber()) {
      return scalarSecond(operator, left, right);
    }
    throw Operators.cannotCombine(operator, left, right);
  }

  private static boolean numbers(Value value) {
    return value instanceof NumberList list && list.elementKind().isNumber();
  }

  private static NumberList lists(BinaryOperator operator, NumberList a, NumberList b)
      throws ScriptError {
    if (a.length() != b.length()) {
      throw new ScriptError(
          "wrong-length",
          operator.text()
              + ": the lists have "
              + a.length()
              + " and "
              + b.length()
              + " elements, must have equally many");
    }
    int length = a.length();
    boolean integers =
        a.elementKind() == Kind.INT
            && b.elementKind() == Kind.INT
            && operator != BinaryOperator.DIVIDE;
    double[] result = combine(operator, a.elements(), 1, b.elements(), 1, length, integers);
    return NumberList.owning(result, length, integers ? Kind.INT : Kind.FLOAT);
  }

  private static MatrixValue sum(BinaryOperator operator, MatrixValue a, MatrixValue b)
      throws ScriptError {
    if (a.rows() != b.rows() || a.columns() != b.columns()) {
      throw shape(operator, a, "a " + b.rows() + " x " + b.columns() + " matrix");
    }
    double[] left = a.elements();
    boolean integers = a.integers() && b.integers();
    double[] result = combine(operator, left, 1, b.elements(), 1, left.length, integers);
    return MatrixValue.owning(a.rows(), a.columns(), result, integers);
  }

  private static Value scalarFirst(BinaryOperator operator, Value scalar, Value many)
      throws ScriptError {
    double[] one = {Operators.number(scalar)};
    boolean mayBeIntegers = scalar.kind() == Kind.INT && operator != BinaryOperator.DIVIDE;
    return switch (many) {
      case NumberList list when list.elementKind().isNumber() -> {
        boolean integers = mayBeIntegers && list.elementKind() == Kind.INT;
        int length = list.length();
        double[] result = combine(operator, one, 0, list.elements(), 1, length, integers);
        yield NumberList.owning(result, length, integers ? Kind.INT : Kind.FLOAT);
      }
      case MatrixValue matrix -> {
        boolean integers = mayBeIntegers && matrix.integers();
        double[] right = matrix.elements();
        double[] result = combine(operator, one, 0, right, 1, right.length, integers);
        yield MatrixValue.owning(matrix.rows(), matrix.columns(), result, integers);
      }
      default -> throw Operators.cannotCombine(operator, scalar, many);
    };
  }

  private static Value scalarSecond(BinaryOperator operator, Value many, Value scalar)
      throws ScriptError {
    double[] one = {Operators.number(scalar)};
    boolean mayBeIntegers = scalar.kind() == Kind.INT && operator != BinaryOperator.DIVIDE;
    return switch (many) {
      case NumberList list when list.elementKind().isNumber() -> {
        boolean integers = mayBeIntegers && list.elementKind() == Kind.INT;
        int length = list.length();
        double[] result = combine(operator, list.elements(), 1, one, 0, length, integers);
        yield NumberList.owning(result, length, integers ? Kind.INT : Kind.FLOAT);
      }
      case MatrixValue matrix -> {
        boolean integers = mayBeIntegers && matrix.integers();
        double[] left = matrix.elements();
        double[] result = combine(operator, left, 1, one, 0, left.length, integers);
        yield MatrixValue.owning(matrix.rows(), matrix.columns(), result, integers);
      }
      default -> throw Operators.cannotCombine(operator, many, scalar);
    };
  }

  /** {@code count} results; a side with step 0 is one number for all of them. */
  private static double[] combine(
      BinaryOperator operator,
      double[] a,
      int aStep,
      double[] b,
      int bStep,
      int count,
      boolean integers)
      throws ScriptError {
    double[] result = new double[count];
    switch (operator) {
      case ADD -> {
        for (int i = 0; i < count; i++) {
          result[i] = a[i * aStep] + b[i * bStep];
        }
      }
      case SUBTRACT -> {
        for (int i = 0; i < count; i++) {
          result[i] = a[i * aStep] - b[i * bStep];
        }
      }
      case MULTIPLY -> {
        for (int i = 0; i < count; i++) {
          result[i] = a[i * aStep] * b[i * bStep];
        }
      }
      case DIVIDE -> {
        refuseZero(operator, b, bStep, count);
        for (int i = 0; i < count; i++) {
          result[i] = a[i * aStep] / b[i * bStep];
        }
      }
      case MODULO -> {
        refuseZero(operator, b, bStep, count);
        for (int i = 0; i < count; i++) {
          result[i] = a[i * aStep] % b[i * bStep];
        }
      }
      default -> throw new IllegalArgumentException(operator.text() + " is not arithmetic");
    }
    if (integers) {
      asIntegers(operator, result);
    }
    return result;
  }

  private static void refuseZero(BinaryOperator operator, double[] divisors, int step, int count)
      throws ScriptError {
    for (int i = 0; i < count; i++) {
      if (divisors[i * step] == 0) {
        throw Operators.divisionByZero(operator);
      }
    }
  }

  /** Refuses what does not fit an int, and makes a negative zero an ordinary one. */
  private static void asIntegers(BinaryOperator operator, double[] numbers) throws ScriptError {
    for (int i = 0; i < numbers.length; i++) {
      int integer = (int) numbers[i];
      if (integer != numbers[i]) {
        throw Operators.integerOverflow(operator.text(), numbers[i]);
      }
      numbers[i] = integer;
    }
  }

  private static MatrixValue product(MatrixValue left, MatrixValue right) throws ScriptError {
    int inner = left.columns();
    if (inner != right.rows()) {
      throw shape(
          BinaryOperator.MULTIPLY,
          left,
          "a "
              + right.rows()
              + " x "
              + right.columns()
              + " matrix; the first must have as many"
              + " columns as the second has rows");
    }
    int rows = left.rows();
    int columns = right.columns();
    double[] a = left.elements();
    double[] b = right.elements();
    double[] result = new double[rows * columns];
    for (int row = 0; row < rows; row++) {
      int target = row * columns;
      for (int k = 0; k < inner; k++) {
        double factor = a[row * inner + k];
        int source = k * columns;
        for (int column = 0; column < columns; column++) {
          result[target + column] += factor * b[source + column];
        }
      }
    }
    boolean integers = left.integers() && right.integers();
    if (integers) {
      asIntegers(BinaryOperator.MULTIPLY, result);
    }
    return MatrixValue.owning(rows, columns, result, integers);
  }

  private static NumberList product(MatrixValue left, NumberList right) throws ScriptError {
    int columns = left.columns();
    if (columns != right.length()) {
      throw shape(
          BinaryOperator.MULTIPLY,
          left,
          "a list of " + right.length() + "; it must have one element a column");
    }
    double[] a = left.elements();
    double[] b = right.elements();
    double[] result = new double[left.rows()];
    for (int row = 0; row < result.length; row++) {
      double sum = 0;
      for (int column = 0; column < columns; column++) {
        sum += a[row * columns + column] * b[column];
      }
      result[row] = sum;
    }
    boolean integers = left.integers() && right.elementKind() == Kind.INT;
    if (integers) {
      asIntegers(BinaryOperator.MULTIPLY, result);
    }
    return NumberList.owning(result, result.length, integers ? Kind.INT : Kind.FLOAT);
  }

  private static ScriptError shape(BinaryOperator operator, MatrixValue left, String right) {
    return new ScriptError(
        "wrong-length",
        operator.text() + ": cannot combine " + Operators.described(left) + " and " + right);
  }
}
