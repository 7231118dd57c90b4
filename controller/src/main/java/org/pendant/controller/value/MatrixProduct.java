package org.pendant.controller.value;

import org.pendant.language.syntax.Expression.BinaryOperator;

/** The product of two matrices, some rows of the result at a time. */
final class MatrixProduct implements LongOperation {
  private final MatrixValue left;
  private final MatrixValue right;
  private final double[] a;
  private final double[] b;
  private final int inner;
  private final int columns;
  private final boolean integers;
  private final double[] result;

  /** How many elements of the left matrix are done, row after row. */
  private int next;

  /** A product of matrices whose shapes fit. */
  MatrixProduct(MatrixValue left, MatrixValue right) {
    this.left = left;
    this.right = right;
    a = left.elements();
    b = right.elements();
    inner = left.columns();
    columns = right.columns();
    integers = left.integers() && right.integers();
    result = new double[left.rows() * columns];
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
      if (source == b.length) {
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
  public MatrixValue result() {
    return MatrixValue.owning(left.rows(), columns, result, integers);
  }

  @Override
  public void keep() {
    left.copy();
    right.copy();
  }
}
