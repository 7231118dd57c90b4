package org.pendant.script.value;

/** Matrix construction from lists of numbers, some rows at a time. */
final class MatrixRows implements LongOperation {
  private final NumberList[] rows;
  private final int columns;
  private final boolean integers;
  private final double[] elements;
  private int next;

  /** A matrix of rows of equal length. */
  MatrixRows(NumberList... rows) {
    this.rows = rows;
    columns = rows[0].length();
    elements = new double[rows.length * columns];
    boolean all = true;
    for (NumberList row : rows) {
      all &= row.elementKind() == ValueKind.INT;
    }
    integers = all;
  }

  @Override
  public int advance() {
    int count = Math.min(Math.max(1, PIECE / columns), rows.length - next);
    for (int i = next; i < next + count; i++) {
      System.arraycopy(rows[i].elements(), 0, elements, i * columns, columns);
    }
    next += count;
    return count * columns;
  }

  @Override
  public boolean done() {
    return next == rows.length;
  }

  @Override
  public MatrixValue result() {
    return MatrixValue.owning(rows.length, columns, elements, integers);
  }

  @Override
  public void keep() {
    for (int i = next; i < rows.length; i++) {
      rows[i] = rows[i].copy();
    }
  }

  @Override
  public long sizeBytes() {
    return 2L * Double.BYTES * elements.length;
  }
}
