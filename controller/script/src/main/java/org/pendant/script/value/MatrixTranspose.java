package org.pendant.script.value;

/** Transpose of a matrix: its rows as columns, some rows at a time. */
final class MatrixTranspose implements LongOperation {
  /** What an element takes that is not near the one before it in memory, in elements. */
  private static final int FAR = 4;

  private final MatrixValue matrix;
  private final double[] elements;
  private double[] source;
  private int row;

  MatrixTranspose(MatrixValue matrix) {
    this.matrix = matrix;
    source = matrix.elements();
    elements = new double[source.length];
  }

  @Override
  public int advance() {
    int rows = matrix.rows();
    int columns = matrix.columns();
    int count = Math.min(Math.max(1, PIECE / FAR / columns), rows - row);
    for (int i = row; i < row + count; i++) {
      for (int column = 0; column < columns; column++) {
        elements[column * rows + i] = source[i * columns + column];
      }
    }
    row += count;
    return FAR * count * columns;
  }

  @Override
  public boolean done() {
    return row == matrix.rows();
  }

  @Override
  public MatrixValue result() {
    return MatrixValue.owning(matrix.columns(), matrix.rows(), elements, matrix.integers());
  }

  @Override
  public void keep() {
    source = matrix.copy().elements();
  }

  @Override
  public long sizeBytes() {
    return 2L * Double.BYTES * elements.length;
  }
}
