package org.pendant.script.value;

import java.util.Arrays;

/** A matrix of numbers, row after row (manual 5). Like a list it is all int or all float. */
public final class MatrixValue extends Container implements Value {
  /** Most elements that a matrix may have. */
  public static final int MAX_ELEMENTS = 4_000_000;

  /** Matrices up to this size are copied at once: sharing would cost more than it saves. */
  private static final int MAX_COPIED = 36;

  private final int rows;
  private final int columns;
  private double[] elements;
  private boolean integers;

  private MatrixValue(int rows, int columns, double[] elements, boolean integers) {
    this.rows = rows;
    this.columns = columns;
    this.elements = elements;
    this.integers = integers;
  }

  /** A matrix that owns {@code elements}, {@code rows} times {@code columns} of them by rows. */
  public static MatrixValue owning(int rows, int columns, double[] elements, boolean integers) {
    if (rows < 1 || columns < 1 || elements.length != rows * columns) {
      throw new IllegalArgumentException(
          elements.length + " elements for " + rows + " x " + columns);
    }
    return new MatrixValue(rows, columns, elements, integers);
  }

  /**
   * Refuses a shape with too many elements.
   *
   * @throws ScriptError beyond {@link #MAX_ELEMENTS}
   */
  static void check(int rows, int columns) throws ScriptError {
    if ((long) rows * columns > MAX_ELEMENTS) {
      throw new ScriptError(
          "too-large",
          ValueTexts.text("matrixTooLarge", rows, columns, (long) rows * columns, MAX_ELEMENTS));
    }
  }

  public int rows() {
    return rows;
  }

  public int columns() {
    return columns;
  }

  /** Whether all elements are ints. */
  public boolean integers() {
    return integers;
  }

  /** Element {@code i} counted row by row, unchecked. */
  public double numberAt(int i) {
    return elements[i];
  }

  /**
   * The elements row by row, for loops: not a copy, and another array after a change of what is
   * {@code shared}.
   */
  public double[] elements() {
    return elements;
  }

  @Override
  Object array() {
    return elements;
  }

  /** Whether there is an element in {@code row} and {@code column}. */
  public boolean has(double row, double column) {
    return row >= 0 && row < rows && column >= 0 && column < columns;
  }

  /** The element in a row and column that the caller knows to be there. */
  public double numberAt(int row, int column) {
    return elements[row * columns + column];
  }

  /**
   * Replaces the element in a row and column that the caller knows to be there, by a number of the
   * elements' kind; not for a matrix that shares its elements.
   */
  public void setNumberAt(int row, int column, double number) {
    elements[row * columns + column] = number;
  }

  /** The {@link Registers} tag of the elements. */
  public int tag() {
    return integers ? Registers.INT : Registers.FLOAT;
  }

  public double get(int row, int column) throws ScriptError {
    return elements[place(row, column)];
  }

  /** Replaces one element; {@code integer} says whether the number is an int. */
  public void set(int row, int column, double number, boolean integer) throws ScriptError {
    int place = place(row, column);
    if (shared()) {
      elements = elements.clone();
      setShared(false);
    }
    elements[place] = number;
    integers &= integer;
  }

  /** Row {@code row} as a list. */
  public NumberList row(int row) throws ScriptError {
    int start = place(row, 0);
    return NumberList.owning(
        Arrays.copyOfRange(elements, start, start + columns), columns, elementKind());
  }

  /** Column {@code column} as a list. */
  public NumberList column(int column) throws ScriptError {
    double[] picked = new double[rows];
    for (int row = 0; row < rows; row++) {
      picked[row] = elements[place(row, column)];
    }
    return NumberList.owning(picked, rows, elementKind());
  }

  public ValueKind elementKind() {
    return integers ? ValueKind.INT : ValueKind.FLOAT;
  }

  private int place(int row, int column) throws ScriptError {
    if (row < 0 || row >= rows || column < 0 || column >= columns) {
      throw new ScriptError(
          "index-out-of-range", ValueTexts.text("matrixIndex", row, column, rows, columns));
    }
    return row * columns + column;
  }

  @Override
  public ValueKind kind() {
    return ValueKind.MATRIX;
  }

  @Override
  public MatrixValue copy() {
    if (elements.length <= MAX_COPIED) {
      return new MatrixValue(rows, columns, elements.clone(), integers);
    }
    MatrixValue copy = new MatrixValue(rows, columns, elements, integers);
    copy.setShared(true);
    setShared(true);
    return copy;
  }

  @Override
  public long sizeBytes() {
    return HEADER_BYTES + (long) Double.BYTES * elements.length;
  }

  /** The text, for people who read tests and debuggers. */
  @Override
  public String toString() {
    return text();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof MatrixValue matrix
        && rows == matrix.rows
        && columns == matrix.columns
        && Arrays.equals(elements, matrix.elements);
  }

  @Override
  public int hashCode() {
    return 31 * (31 * rows + columns) + Arrays.hashCode(elements);
  }
}
