package org.pendant.script.value;

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
    integers = left.integers() && right.elementKind() == ValueKind.INT;
    result = new double[left.rows()];
  }

  /** Each element of the left matrix, one after the other, times its row of the right one. */
  @Override
  public int advance() throws ScriptError {
    int count = Math.min(Math.max(1, PIECE / columns), a.length - next);
    int end = next + count;
    for (int i = next; i < end; ) {
      int row = i / inner;
      int rowEnd = Math.min(end, (row + 1) * inner);
      addProducts(row * columns, (i - row * inner) * columns, i, rowEnd);
      i = rowEnd;
    }
    next += count;
    if (done() && integers) {
      Integers.check(BinaryOperator.MULTIPLY, result, 0, result.length);
    }
    return count * columns;
  }

  /**
   * Adds to a row of the result.
   *
   * @param target where that row begins
   * @param source where the row of the right matrix begins that element {@code from} goes with
   * @param to after the last element of the left matrix
   */
  private void addProducts(int target, int source, int from, int to) {
    double[] sums = result;
    double[] factors = b;
    int width = columns;
    int place = source;
    int i = from;
    // two at a time, added in the same order as one by one
    for (; i + 1 < to; i += 2) {
      double first = a[i];
      double second = a[i + 1];
      int below = place + width;
      for (int column = 0; column < width; column++) {
        sums[target + column] =
            sums[target + column]
                + first * factors[place + column]
                + second * factors[below + column];
      }
      place = below + width;
    }
    for (; i < to; i++) {
      double factor = a[i];
      for (int column = 0; column < width; column++) {
        sums[target + column] += factor * factors[place + column];
      }
      place += width;
    }
  }

  @Override
  public boolean done() {
    return next == a.length;
  }

  @Override
  public Value result() {
    return right instanceof MatrixValue
        ? MatrixValue.owning(left.rows(), columns, result, integers)
        : NumberList.owning(result, result.length, integers ? ValueKind.INT : ValueKind.FLOAT);
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
