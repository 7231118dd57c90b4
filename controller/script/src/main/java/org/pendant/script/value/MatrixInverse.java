package org.pendant.script.value;

import static org.pendant.script.value.ValueTexts.text;

import java.util.Arrays;

/**
 * The inverse of a square matrix, some rows at a time: Gauss-Jordan elimination in place with row
 * pivoting (Golub, Van Loan, Matrix Computations, 3.4).
 */
final class MatrixInverse implements LongOperation {
  /**
   * Smallest reciprocal condition number of a matrix that counts as invertible: at the precision of
   * a double, below it not one digit of an inverse would be right.
   */
  private static final double MIN_RECIPROCAL_CONDITION = 1e-15;

  private final int size;
  private final double[] a;
  private final double normOfOriginal;

  /** The row that was exchanged with each row. */
  private final int[] pivots;

  private int column;

  /** The next row from which a multiple of the pivot row is taken. */
  private int row;

  private boolean singular;

  MatrixInverse(MatrixValue matrix) {
    size = matrix.rows();
    a = matrix.elements().clone();
    pivots = new int[size];
    normOfOriginal = norm();
  }

  @Override
  public int advance() {
    int work = 0;
    while (work < PIECE && !done()) {
      if (row == 0) {
        pivot();
        work += size;
      }
      if (row != column) {
        eliminate(row);
      }
      work += size;
      row++;
      if (row == size) {
        row = 0;
        column++;
      }
    }
    return work;
  }

  /** Brings the largest element left in the column to the diagonal, and divides its row by it. */
  private void pivot() {
    int best = column;
    for (int i = column + 1; i < size; i++) {
      if (Math.abs(a[i * size + column]) > Math.abs(a[best * size + column])) {
        best = i;
      }
    }
    pivots[column] = best;
    double pivot = a[best * size + column];
    if (pivot == 0 || !Double.isFinite(pivot)) {
      singular = true;
      return;
    }
    exchangeRows(column, best);
    int start = column * size;
    a[start + column] = 1;
    for (int i = start; i < start + size; i++) {
      a[i] /= pivot;
    }
  }

  private void exchangeRows(int x, int y) {
    for (int i = 0; x != y && i < size; i++) {
      double kept = a[x * size + i];
      a[x * size + i] = a[y * size + i];
      a[y * size + i] = kept;
    }
  }

  private void eliminate(int target) {
    int start = target * size;
    int source = column * size;
    double factor = a[start + column];
    a[start + column] = 0;
    for (int i = 0; factor != 0 && i < size; i++) {
      a[start + i] -= factor * a[source + i];
    }
  }

  @Override
  public boolean done() {
    return singular || column == size;
  }

  /**
   * The inverse.
   *
   * @throws ScriptError if there is none, or none but for rounding
   */
  @Override
  public MatrixValue result() throws ScriptError {
    if (!singular) {
      exchangeColumns();
    }
    double condition = normOfOriginal * norm();
    // not a number is no inverse either
    if (singular || !(1 / condition > MIN_RECIPROCAL_CONDITION)) {
      throw new ScriptError("matrix-singular", text("singular"));
    }
    return MatrixValue.owning(size, size, a, false);
  }

  /** Rows that were exchanged before are columns of the inverse. */
  private void exchangeColumns() {
    for (int i = 0; i < a.length; i += size) {
      for (int k = size - 1; k >= 0; k--) {
        double kept = a[i + k];
        a[i + k] = a[i + pivots[k]];
        a[i + pivots[k]] = kept;
      }
    }
  }

  /** The largest sum of magnitudes in a column. */
  private double norm() {
    double[] sums = new double[size];
    for (int i = 0; i < a.length; i += size) {
      for (int k = 0; k < size; k++) {
        sums[k] += Math.abs(a[i + k]);
      }
    }
    return Arrays.stream(sums).reduce(0, Math::max);
  }

  @Override
  public void keep() {
    // it works on its own copy
  }

  @Override
  public long sizeBytes() {
    return (long) Double.BYTES * a.length;
  }
}
