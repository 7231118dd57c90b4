package org.pendant.command;

import java.math.BigDecimal;
import java.math.RoundingMode;

/** Decimal numbers as people write them. */
final class Decimal {
  private Decimal() {}

  /**
   * {@code value} with at most {@code digits} digits after the point, and no zeros at their end.
   */
  static String text(double value, int digits) {
    BigDecimal rounded = BigDecimal.valueOf(value).setScale(digits, RoundingMode.HALF_UP);
    return rounded.stripTrailingZeros().toPlainString();
  }
}
