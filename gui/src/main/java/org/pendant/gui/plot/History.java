package org.pendant.gui.plot;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import org.pendant.controller.state.ControllerState;

/**
 * Ten minutes of the quantities that are drawn, as columns of numbers with one column of times.
 * Samples have numbers that never change; times rise with them. One thread uses it.
 */
final class History {
  /** Ten minutes at 125 samples a second. */
  static final int KEPT = 600 * 125;

  private final Tape tape;
  private final double[] timeS = new double[KEPT];
  private final Map<Quantity, double[]> columns = new LinkedHashMap<>();
  private long first;
  private long end;

  /** A history that follows a tape, beginning with what is on it. */
  History(Tape tape) {
    this.tape = tape;
    first = tape.first();
    end = first;
  }

  /** Takes what is new on the tape; returns whether there was anything. */
  boolean follow() {
    long newest = tape.end();
    if (newest == end) {
      return false;
    }
    if (tape.first() > end) {
      // more has gone by than the tape holds: an honest gap is better than a line across it
      first = tape.first();
      end = first;
    }
    for (long number = end; number < newest; number++) {
      take(number, tape.at(number));
    }
    end = newest;
    first = Math.max(first, end - KEPT);
    return true;
  }

  private void take(long number, ControllerState state) {
    int slot = slot(number);
    timeS[slot] = state.timeS();
    if (number > first && timeS[slot] <= timeS[slot(number - 1)]) {
      // another controller has been switched on, its time begins again
      first = number;
    }
    columns.forEach((quantity, column) -> column[slot] = quantity.value().applyAsDouble(state));
  }

  /** Keeps a quantity from now on, and what the tape has of it. */
  void track(Quantity quantity) {
    if (columns.containsKey(quantity)) {
      return;
    }
    double[] column = new double[KEPT];
    Arrays.fill(column, Double.NaN);
    for (long number = Math.max(first, tape.first()); number < end; number++) {
      column[slot(number)] = quantity.value().applyAsDouble(tape.at(number));
    }
    columns.put(quantity, column);
  }

  /** Forgets a quantity. */
  void untrack(Quantity quantity) {
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

  /** Time of the newest sample, s; 0 without one. */
  double newestS() {
    return empty() ? 0 : timeS(end - 1);
  }

  /** Value of a tracked quantity; not a number where it was not tracked yet. */
  double value(Quantity quantity, long number) {
    return columns.get(quantity)[slot(number)];
  }

  /** Takes samples one after another. */
  interface Visitor {
    /** One sample; returns whether more are wanted. */
    boolean sample(double timeS, double value);
  }

  /** Shows the samples of a tracked quantity from number {@code begin} on, known values only. */
  void visit(Quantity quantity, long begin, Visitor visitor) {
    double[] column = columns.get(quantity);
    int slot = slot(begin);
    for (long number = begin; number < end; number++) {
      double value = column[slot];
      if (!Double.isNaN(value) && !visitor.sample(timeS[slot], value)) {
        return;
      }
      slot = slot + 1 == KEPT ? 0 : slot + 1;
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
  double valueAt(Quantity quantity, double time) {
    long after = firstAtLeast(Math.nextUp(time));
    return after == first ? Double.NaN : value(quantity, after - 1);
  }

  private static int slot(long number) {
    return (int) (number % KEPT);
  }
}
