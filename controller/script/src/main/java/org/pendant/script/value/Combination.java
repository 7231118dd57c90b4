package org.pendant.script.value;

import java.util.function.Function;
import org.pendant.language.syntax.Expression.BinaryOperator;

/** Combination of two lists or matrices: arithmetic element by element. */
final class Combination implements LongOperation {
  private final BinaryOperator operator;
  private final Value left;
  private final Value right;
  private double[] a;
  private final int aStep;
  private double[] b;
  private final int bStep;
  private final boolean integers;
  private final Function<double[], Value> make;
  private final double[] result;
  private int next;

  /**
   * The combination of {@code count} pairs; an operand that is a single number serves for all of
   * them.
   *
   * @param integers whether the results have to be ints
   * @param make what becomes of the results
   */
  Combination(
      BinaryOperator operator,
      Value left,
      Value right,
      int count,
      boolean integers,
      Function<double[], Value> make) {
    this.operator = operator;
    this.left = left;
    this.right = right;
    a = elements(left);
    aStep = left.kind().isNumber() ? 0 : 1;
    b = elements(right);
    bStep = right.kind().isNumber() ? 0 : 1;
    this.integers = integers;
    this.make = make;
    result = new double[count];
  }

  private static double[] elements(Value value) {
    return switch (value) {
      case NumberList list -> list.elements();
      case MatrixValue matrix -> matrix.elements();
      default -> new double[] {Operators.number(value)};
    };
  }

  @Override
  public int advance() throws ScriptError {
    int from = next;
    int to = Math.min(result.length, from + PIECE);
    switch (operator) {
      case ADD -> {
        for (int i = from; i < to; i++) {
          result[i] = a[i * aStep] + b[i * bStep];
        }
      }
      case SUBTRACT -> {
        for (int i = from; i < to; i++) {
          result[i] = a[i * aStep] - b[i * bStep];
        }
      }
      case MULTIPLY -> {
        for (int i = from; i < to; i++) {
          result[i] = a[i * aStep] * b[i * bStep];
        }
      }
      case DIVIDE -> {
        refuseZero(from, to);
        for (int i = from; i < to; i++) {
          result[i] = a[i * aStep] / b[i * bStep];
        }
      }
      case MODULO -> {
        refuseZero(from, to);
        for (int i = from; i < to; i++) {
          result[i] = a[i * aStep] % b[i * bStep];
        }
      }
      default -> throw new IllegalArgumentException(operator.text() + " is not arithmetic");
    }
    if (integers) {
      Integers.check(operator, result, from, to);
    }
    next = to;
    return to - from;
  }

  private void refuseZero(int from, int to) throws ScriptError {
    for (int i = from; i < to; i++) {
      if (b[i * bStep] == 0) {
        throw Operators.divisionByZero(operator);
      }
    }
  }

  @Override
  public boolean done() {
    return next == result.length;
  }

  @Override
  public Value result() {
    return make.apply(result);
  }

  @Override
  public void keep() {
    a = elements(left.copy());
    b = elements(right.copy());
  }

  @Override
  public long sizeBytes() {
    return left.sizeBytes() + right.sizeBytes() + (long) Double.BYTES * result.length;
  }
}
