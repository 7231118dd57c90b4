package org.pendant.sweep.plan;

import java.math.BigDecimal;

/**
 * Parameter value: what a variant has for one parameter.
 *
 * @param text as a script or a table writes it, such as {@code 0.25}, {@code True} or {@code p[0.4,
 *     0, 0.2, 0, 3.14, 0]}
 * @param number the same as a number; not a number (NaN) where it is none
 */
public record ParameterValue(String text, double number) {

  /** A number; a whole one is written without a point. */
  public static ParameterValue of(double number, boolean whole) {
    return whole ? of((long) Math.rint(number)) : of(number);
  }

  /** A whole number. */
  public static ParameterValue of(long number) {
    return new ParameterValue(Long.toString(number), number);
  }

  /** A number that is not whole, or need not be. */
  public static ParameterValue of(double number) {
    // without an exponent, but with a point: to a script 2 is another kind of number than 2.0
    double signed = number + 0.0;
    BigDecimal digits = new BigDecimal(Double.toString(signed)).stripTrailingZeros();
    String text = digits.scale() <= 0 ? digits.setScale(1).toPlainString() : digits.toPlainString();
    return new ParameterValue(text, signed);
  }

  /** A text that is no number. */
  public static ParameterValue of(String text) {
    return new ParameterValue(text, Double.NaN);
  }

  /** Whether it is a number. */
  public boolean numeric() {
    return !Double.isNaN(number);
  }
}
