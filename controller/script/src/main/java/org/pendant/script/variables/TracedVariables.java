package org.pendant.script.variables;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Traced numbers: those wanted in every frame, as they were at the end of one. Immutable; the same
 * object as long as nothing changes.
 */
public final class TracedVariables {
  /** None are wanted. */
  public static final TracedVariables NONE =
      new TracedVariables(new Names(List.of()), new double[0]);

  private final Names names;
  private final double[] values;

  /** Where the numbers are; all frames share one. */
  static final class Names {
    private final List<String> all;
    private final Map<String, Integer> places = new HashMap<>();

    Names(List<String> all) {
      this.all = List.copyOf(all);
      for (int i = 0; i < all.size(); i++) {
        places.put(all.get(i), i);
      }
    }
  }

  private TracedVariables(Names names, double[] values) {
    this.names = names;
    this.values = values;
  }

  /**
   * Numbers that were traced before, such as those of a recording.
   *
   * @param values one for each of {@code names}
   * @throws IllegalArgumentException if there are more or fewer
   */
  public static TracedVariables of(List<String> names, double... values) {
    return new TracedVariables(new Names(names), checked(values, names.size()));
  }

  /**
   * The same names with other numbers.
   *
   * @param others one for each name
   * @throws IllegalArgumentException if there are more or fewer
   */
  public TracedVariables withValues(double... others) {
    return new TracedVariables(names, checked(others, names.all.size()));
  }

  private static double[] checked(double[] values, int count) {
    if (values.length != count) {
      throw new IllegalArgumentException(
          "traced variables: has " + values.length + " values, must have " + count);
    }
    return values.clone();
  }

  /** Takes over {@code values}, one for each name. */
  static TracedVariables owning(Names names, double[] values) {
    return new TracedVariables(names, values);
  }

  boolean hasValues(double[] wanted) {
    return Arrays.equals(values, wanted);
  }

  /** What is traced, as {@link VariablePath#text} writes it; the same list while it stays. */
  public List<String> names() {
    return names.all;
  }

  /** Whether {@code name} is among the {@link #names}. */
  public boolean has(String name) {
    return names.places.containsKey(name);
  }

  /**
   * The number called {@code name}, 0 or 1 for a boolean; NaN when it is not traced, when the
   * running or last program has no such variable or has not assigned it yet, and when it is no
   * number.
   */
  public double value(String name) {
    Integer place = names.places.get(name);
    return place == null ? Double.NaN : values[place];
  }

  /** Number {@code place} of {@link #names}. */
  public double value(int place) {
    return values[place];
  }
}
