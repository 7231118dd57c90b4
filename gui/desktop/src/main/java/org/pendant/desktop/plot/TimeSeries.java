package org.pendant.desktop.plot;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/**
 * Time series: columns of numbers with one column of times, which rise; the oldest go. Samples have
 * numbers that never change. One thread uses it.
 */
final class TimeSeries {
  private final int kept;
  private double[] timeS = {};
  private final Map<ChartQuantity, double[]> columns = new LinkedHashMap<>();
  private long first;
  private long end;

  /**
   * Without samples.
   *
   * @param kept how many samples are
   * @param first the number of the first one to come
   */
  TimeSeries(int kept, long first) {
    this.kept = kept;
    this.first = first;
    end = first;
  }

  /** Forgets everything; the next sample has number {@code number}. */
  void startAt(long number) {
    first = number;
    end = number;
  }

  /** Adds a sample. */
  void take(double atS, ToDoubleFunction<ChartQuantity> values) {
    if (timeS.length == 0) {
      // made when it is needed: it takes megabytes
      timeS = new double[kept];
    }
    int slot = slot(end);
    timeS[slot] = atS;
    if (end > first && atS <= timeS[slot(end - 1)]) {
      // another controller has been switched on, its time begins again
      first = end;
    }
    columns.forEach((quantity, column) -> column[slot] = values.applyAsDouble(quantity));
    end++;
    first = Math.max(first, end - kept);
  }

  boolean has(ChartQuantity quantity) {
    return columns.containsKey(quantity);
  }

  /** A column for a quantity that is not known yet; it is filled where its past is known. */
  void add(ChartQuantity quantity) {
    double[] column = new double[kept];
    Arrays.fill(column, Double.NaN);
    columns.put(quantity, column);
  }

  void set(ChartQuantity quantity, long number, double value) {
    columns.get(quantity)[slot(number)] = value;
  }

  void remove(ChartQuantity quantity) {
    columns.remove(quantity);
  }

  /** Number of the oldest sample. */
  long first() {
    return first;
  }

  /** One more than the number of the newest. */
  long end() {
    return end;
  }

  boolean empty() {
    return first == end;
  }

  /** Time of a sample, s. */
  double timeS(long number) {
    return timeS[slot(number)];
  }

  /** Value of a quantity in a sample; not a number where it was not known. */
  double value(ChartQuantity quantity, long number) {
    return columns.get(quantity)[slot(number)];
  }

  /** Takes samples one after another. */
  interface Visitor {
    /** One sample; returns whether more are wanted. */
    boolean sample(double timeS, double value);
  }

  /** Shows the samples of a quantity from number {@code begin} on; unknown values are NaN. */
  void visit(ChartQuantity quantity, long begin, Visitor visitor) {
    double[] column = columns.get(quantity);
    int slot = slot(begin);
    for (long number = begin; number < end; number++) {
      if (!visitor.sample(timeS[slot], column[slot])) {
        return;
      }
      slot = slot + 1 == kept ? 0 : slot + 1;
    }
  }

  /** Number of the first sample at or after a time; the end if there is none. */
  long firstAtLeast(double time) {
    long low = first;
    long high = end;
    while (low < high) {
      long middle = (low + high) >>> 1;
      if (timeS(middle) < time) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /** Value of a quantity at a time, that of the last sample until then; not a number before. */
  double valueAt(ChartQuantity quantity, double time) {
    long after = firstAtLeast(Math.nextUp(time));
    return after == first ? Double.NaN : value(quantity, after - 1);
  }

  private int slot(long number) {
    return (int) (number % kept);
  }
}
