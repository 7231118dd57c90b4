package org.pendant.recording;

/**
 * Column trace: a number over equal stretches of time. A stretch without a value, outside of the
 * recording or where there was none, has NaN.
 */
public final class ColumnTrace {
  private final double fromS;
  private final double widthS;
  private final double[] lowest;
  private final double[] highest;
  private final double[] last;

  ColumnTrace(double fromS, double widthS, double[] lowest, double[] highest, double[] last) {
    this.fromS = fromS;
    this.widthS = widthS;
    this.lowest = lowest;
    this.highest = highest;
    this.last = last;
  }

  /** How many stretches there are. */
  public int size() {
    return last.length;
  }

  /** When stretch {@code i} begins, robot time, s. */
  public double timeS(int i) {
    return fromS + i * widthS;
  }

  /** The least value in stretch {@code i}. */
  public double lowest(int i) {
    return lowest[i];
  }

  /** The greatest value in stretch {@code i}. */
  public double highest(int i) {
    return highest[i];
  }

  /** The value at the end of stretch {@code i}. */
  public double last(int i) {
    return last[i];
  }
}
