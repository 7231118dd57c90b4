package org.pendant.project.installation.text;

import java.util.List;
import java.util.Locale;

/** Words of the format: how constants and numbers are written. */
final class Words {
  /** Above it whole numbers are written as doubles are. */
  private static final double MAX_WHOLE = 1e15;

  private Words() {}

  /** A constant, such as {@code low-when-not-running}. */
  static String of(Enum<?> constant) {
    return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /** Several constants, in brackets. */
  static String of(List<? extends Enum<?>> constants) {
    return "[" + String.join(", ", constants.stream().map(Words::of).toList()) + "]";
  }

  /** As many digits as it takes to read the same number again; whole ones without a point. */
  static String of(double number) {
    if (Double.isInfinite(number)) {
      return number < 0 ? "-inf" : "inf";
    }
    boolean minusZero = number == 0 && 1 / number < 0;
    return number == Math.rint(number) && !minusZero && Math.abs(number) < MAX_WHOLE
        ? Long.toString((long) number)
        : Double.toString(number);
  }

  /** As {@link #of(double)}, for a number of half the digits. */
  static String of(float number) {
    return number == Math.rint(number) && !Float.isInfinite(number)
        ? of((double) number)
        : Float.toString(number);
  }

  /** Several numbers, in brackets. */
  static String of(double... numbers) {
    StringBuilder out = new StringBuilder("[");
    for (int i = 0; i < numbers.length; i++) {
      out.append(i == 0 ? "" : ", ").append(of(numbers[i]));
    }
    return out.append(']').toString();
  }
}
