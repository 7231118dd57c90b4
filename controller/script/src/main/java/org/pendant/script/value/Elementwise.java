package org.pendant.script.value;

import static org.pendant.script.value.ValueTexts.text;

import org.pendant.language.syntax.Expression.BinaryOperator;

/**
 * Elementwise arithmetic of lists and matrices of numbers (manual 5). Results of ints are ints,
 * except those of a division.
 */
final class Elementwise {
  private Elementwise() {}

  static Value apply(BinaryOperator operator, Value left, Value right) throws ScriptError {
    return LongOperation.finish(begin(operator, left, right));
  }

  /**
   * Begins what {@link #apply} does at once.
   *
   * @throws ScriptError for kinds and shapes that the operator cannot combine
   */
  static LongOperation begin(BinaryOperator operator, Value left, Value right) throws ScriptError {
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
      return scalar(operator, left, right, right);
    }
    if (right.kind().isNumber()) {
      return scalar(operator, left, right, left);
    }
    throw Operators.cannotCombine(operator, left, right);
  }

  private static boolean numbers(Value value) {
    return value instanceof NumberList list && list.elementKind().isNumber();
  }

  private static LongOperation lists(BinaryOperator operator, NumberList a, NumberList b)
      throws ScriptError {
    if (a.length() != b.length()) {
      throw new ScriptError(
          "wrong-length", text("listLengths", operator.text(), a.length(), b.length()));
    }
    boolean integers =
        a.elementKind() == ValueKind.INT
            && b.elementKind() == ValueKind.INT
            && operator != BinaryOperator.DIVIDE;
    return list(operator, a, b, a.length(), integers);
  }

  private static LongOperation list(
      BinaryOperator operator, Value left, Value right, int length, boolean integers) {
    ValueKind kind = integers ? ValueKind.INT : ValueKind.FLOAT;
    return new Combination(
        operator, left, right, length, integers, r -> NumberList.owning(r, r.length, kind));
  }

  private static LongOperation sum(BinaryOperator operator, MatrixValue a, MatrixValue b)
      throws ScriptError {
    if (a.rows() != b.rows() || a.columns() != b.columns()) {
      throw shape(
          text("cannotCombine", operator.text(), Operators.described(a), Operators.described(b)));
    }
    return matrix(operator, a, b, a, a.integers() && b.integers());
  }

  private static LongOperation matrix(
      BinaryOperator operator, Value left, Value right, MatrixValue like, boolean integers) {
    int rows = like.rows();
    int columns = like.columns();
    return new Combination(
        operator,
        left,
        right,
        rows * columns,
        integers,
        r -> MatrixValue.owning(rows, columns, r, integers));
  }

  /** A number and {@code many}, which is either {@code left} or {@code right}. */
  private static LongOperation scalar(BinaryOperator operator, Value left, Value right, Value many)
      throws ScriptError {
    boolean mayBeIntegers =
        (left.kind() == ValueKind.INT || right.kind() == ValueKind.INT)
            && operator != BinaryOperator.DIVIDE;
    return switch (many) {
      case NumberList list when list.elementKind().isNumber() -> {
        boolean integers = mayBeIntegers && list.elementKind() == ValueKind.INT;
        yield list(operator, left, right, list.length(), integers);
      }
      case MatrixValue matrix ->
          matrix(operator, left, right, matrix, mayBeIntegers && matrix.integers());
      default -> throw Operators.cannotCombine(operator, left, right);
    };
  }

  private static LongOperation product(MatrixValue left, MatrixValue right) throws ScriptError {
    if (left.columns() != right.rows()) {
      throw shape(
          text(
              "cannotMultiplyMatrices",
              BinaryOperator.MULTIPLY.text(),
              Operators.described(left),
              Operators.described(right)));
    }
    MatrixValue.check(left.rows(), right.columns());
    return new MatrixProduct(left, right);
  }

  private static LongOperation product(MatrixValue left, NumberList right) throws ScriptError {
    int columns = left.columns();
    if (columns != right.length()) {
      throw shape(
          text(
              "cannotMultiplyList",
              BinaryOperator.MULTIPLY.text(),
              Operators.described(left),
              right.length()));
    }
    return new MatrixProduct(left, right);
  }

  private static ScriptError shape(String message) {
    return new ScriptError("wrong-length", message);
  }
}
