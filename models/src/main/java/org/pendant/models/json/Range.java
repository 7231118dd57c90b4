package org.pendant.models.json;

import static org.pendant.models.json.JsonTexts.text;

/**
 * Range: what a number of a file may be; NaN is in no range.
 *
 * @param least the smallest value allowed
 * @param most the largest value allowed
 * @param unit for messages, empty for a plain number
 */
public record Range(double least, double most, String unit) {
  /** Whether {@code value} is allowed. */
  public boolean holds(double value) {
    return value >= least && value <= most;
  }

  /** The message that {@code value} is not allowed. */
  public String refusal(String name, double value) {
    return text("outside", name, measure(value), number(least), measure(most));
  }

  /**
   * Checks a number.
   *
   * @throws IllegalArgumentException if it is outside
   */
  public void require(String name, double value) {
    if (!holds(value)) {
      throw new IllegalArgumentException(refusal(name, value));
    }
  }

  private String measure(double value) {
    return unit.isEmpty() ? number(value) : number(value) + " " + unit;
  }

  /** A number as people write it: no fraction when there is none, seldom an exponent. */
  public static String number(double value) {
    return value == Math.rint(value) && Math.abs(value) < 1e9
        ? Long.toString((long) value)
        : Double.toString(value);
  }
}
