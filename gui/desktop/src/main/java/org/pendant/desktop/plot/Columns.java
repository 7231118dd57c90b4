package org.pendant.desktop.plot;

import java.util.Arrays;

/**
 * Pixel columns of a line: what of it falls on each column of pixels. However many samples there
 * are, no peak is lost and painting takes the same time.
 */
final class Columns {
  private double[] least = new double[0];
  private double[] most = new double[0];
  private double[] first = new double[0];
  private double[] last = new double[0];
  private boolean[] broken = new boolean[0];
  private boolean unknown;

  /** Fills the columns with the part of a quantity that is in a window. */
  void fill(History history, ChartQuantity quantity, TimeWindow window, int width) {
    reset(width);
    // one sample beyond either edge, so that the line reaches the edges
    TimeSeries series = history.of(quantity);
    long begin = Math.max(series.first(), series.firstAtLeast(window.beginS()) - 1);
    double beginS = window.beginS();
    double columnsPerS = width / window.widthS();
    series.visit(
        quantity,
        begin,
        (timeS, value) -> {
          int column = (int) Math.floor((timeS - beginS) * columnsPerS);
          if (Double.isNaN(value)) {
            unknown = true;
          } else {
            add(Math.clamp(column, 0, width - 1), value);
          }
          return column < width;
        });
  }

  private void reset(int width) {
    if (least.length != width) {
      least = new double[width];
      most = new double[width];
      first = new double[width];
      last = new double[width];
      broken = new boolean[width];
    }
    unknown = false;
    Arrays.fill(least, Double.NaN);
  }

  private void add(int column, double value) {
    if (Double.isNaN(least[column])) {
      least[column] = value;
      most[column] = value;
      first[column] = value;
      broken[column] = unknown;
      unknown = false;
    } else {
      least[column] = Math.min(least[column], value);
      most[column] = Math.max(most[column], value);
    }
    last[column] = value;
  }

  /** How far the line goes up and down from one column to the next, in the mean. */
  double meanSpan() {
    double sum = 0;
    int count = 0;
    double before = Double.NaN;
    for (int i = 0; i < least.length; i++) {
      if (has(i)) {
        sum += Math.max(most[i], Double.isNaN(before) ? most[i] : before);
        sum -= Math.min(least[i], Double.isNaN(before) ? least[i] : before);
        before = last[i];
        count++;
      }
    }
    return count == 0 ? 0 : sum / count;
  }

  /** What lies between the least and the most value of a column but not between first and last. */
  double detour(int column) {
    return most[column] - least[column] - Math.abs(last[column] - first[column]);
  }

  int width() {
    return least.length;
  }

  /** Whether any sample falls on a column. */
  boolean has(int column) {
    return !Double.isNaN(least[column]);
  }

  /** Whether the value was unknown between the column before that has one and this. */
  boolean broken(int column) {
    return broken[column];
  }

  double least(int column) {
    return least[column];
  }

  double most(int column) {
    return most[column];
  }

  double first(int column) {
    return first[column];
  }

  double last(int column) {
    return last[column];
  }
}
