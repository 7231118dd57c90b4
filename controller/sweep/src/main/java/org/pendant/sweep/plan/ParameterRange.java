package org.pendant.sweep.plan;

import java.util.List;

/** Parameter range: the values that a parameter may have. */
public sealed interface ParameterRange {

  /**
   * All numbers between two.
   *
   * @param from the least
   * @param to the largest, above the least
   * @param steps how many of them a grid takes, both ends included, 2 or more; 0 where not said
   */
  record Between(double from, double to, int steps) implements ParameterRange {
    /** The number at a share of the way from the least to the largest, 0 to 1. */
    public double at(double share) {
      return share == 1 ? to : from + share * (to - from);
    }
  }

  /** These and no others. */
  record Listed(List<ParameterValue> values) implements ParameterRange {
    /** Copies the list. */
    public Listed {
      values = List.copyOf(values);
    }
  }
}
