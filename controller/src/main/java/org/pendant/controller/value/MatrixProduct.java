package org.pendant.controller.value;

import java.util.function.Function;
import org.pendant.language.syntax.Expression.BinaryOperator;

/** The product of a matrix and a matrix or list, some elements of the first at a time. */
final class MatrixProduct implements LongOperation {
  private final MatrixValue left;
  private final Value right;
  private double[] a;
  private double[] b;
  private final int inner;
  private final int columns;
  private final boolean integers;
  private final Function<double[], Value> make;
  private final double[] result;

  /** How many elements of the left matrix are done, row after row. */
  private int next;

  /** The product of matrices whose shapes fit. */
  MatrixProduct(MatrixValue left, MatrixValue right) {
    this.left = left;
    this.right = right;
    a = left.elements();
    b = right.elements();
    inner = left.columns();
    columns = right.columns();
    integers = left.integers() && right.integers();
    make = r -> MatrixValue.owning(left.rows(), right.columns(), r, integers);
    result = new double[left.rows() * columns];
  }

  /** The product with a list of one number a column of the matrix, which is a list as well. */
  MatrixProduct(MatrixValue left, NumberList right) {
    this.left = left;
    this.right = right;
    a = left.elements();
    b = right.elements();
    inner = left.columns();
    columns = 1;
    integers = left.integers() && right.elementKind() == Kind.INT;
    make = r -> NumberList.owning(r, r.length, integers ? Kind.INT : Kind.FLOAT);
    result = new double[left.rows()];
  }

  /** Each element of the left matrix, one after the other, times its row of the right one. */
  @Override
  public int advance() throws ScriptError {
    int count = Math.min(Math.max(1, PIECE / columns), a.length - next);
    int target = next / inner * columns;
    int source = next % inner * columns;
    for (int i = next; i < next + count; i++) {
      double factor = a[i];
      for (int column = 0; column < columns; column++) {
        result[target + column] += factor * b[source + column];
      }
      source += columns;
      if (source == inner * columns) {
        source = 0;
        target += columns;
      }
    }
    next += count;
    if (done() && integers) {
      Integers.check(BinaryOperator.MULTIPLY, result, 0, result.length);
    }
    return count * columns;
  }

  @Override
  public boolean done() {
    return next == a.length;
  }

  @Override
  public Value result() {
    return make.apply(result);
  }

  @Override
  public void keep() {
    // a small one is not shared by its copy
    a = left.copy().elements();
    b =
        switch (right) {
          case NumberList list -> list.copy().elements();
          case MatrixValue matrix -> matrix.copy().elements();
          default -> b;
        };
  }

  @Override
  public long sizeBytes() {
    return left.sizeBytes() + right.sizeBytes() + (long) Double.BYTES * result.length;
  }
}
