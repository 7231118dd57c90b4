package org.pendant.desktop.program.form;

import org.pendant.kit.form.Measure;

/**
 * Which numbers are legal, in SI.
 *
 * @param min the smallest
 * @param max the largest
 * @param open whether {@code min} itself is not legal
 */
record Range(double min, double max, boolean open) {
  /** Any number. */
  static final Range ANY = new Range(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, false);

  /** 0 or more. */
  static final Range FROM_ZERO = new Range(0, Double.POSITIVE_INFINITY, false);

  /** More than 0. */
  static final Range ABOVE_ZERO = new Range(0, Double.POSITIVE_INFINITY, true);

  /** More than 0, and at most a number. */
  static Range upTo(double max) {
    return new Range(0, max, true);
  }

  /** From one number to another. */
  static Range of(double min, double max) {
    return new Range(min, max, false);
  }

  /** Why a number is not legal; empty if it is. */
  String refusal(double value, Measure measure) {
    boolean low = open ? value <= min : value < min;
    if (Double.isFinite(value) && !low && value <= max) {
      return "";
    }
    return words(measure);
  }

  /** What is legal, such as {@code must be above 0 and at most 250 mm/s}; empty for anything. */
  String words(Measure measure) {
    String unit = measure.symbol().isEmpty() ? "" : " " + measure.symbol();
    boolean bounded = max < Double.POSITIVE_INFINITY;
    if (min == Double.NEGATIVE_INFINITY) {
      return bounded ? "must be at most " + measure.text(max) + unit : "must be a number";
    }
    String least = (open ? "must be above " : "must be ") + measure.text(min);
    if (!bounded) {
      return open ? least + unit : least + unit + " or more";
    }
    return least + (open ? " and at most " : " to ") + measure.text(max) + unit;
  }
}
