package org.pendant.controller.external;

import java.util.OptionalInt;
import java.util.regex.Pattern;

/** Received numbers that a peer sends as text. */
final class ReceivedNumbers {
  /** Java itself would also take {@code 1d} and hexadecimal floats. */
  private static final Pattern NUMBER =
      Pattern.compile("[+-]?(?:[0-9]+\\.?[0-9]*|\\.[0-9]+)(?:[eE][+-]?[0-9]+)?");

  private static final Pattern INTEGER = Pattern.compile("[+-]?[0-9]{1,10}");

  private ReceivedNumbers() {}

  /** The numbers of {@code text}, commas between; none at all where one is not a number. */
  static double[] parse(String text) {
    String[] parts = text.split(",", -1);
    double[] numbers = new double[parts.length];
    for (int i = 0; i < parts.length; i++) {
      String part = parts[i].strip();
      if (!NUMBER.matcher(part).matches()) {
        return new double[0];
      }
      numbers[i] = Double.parseDouble(part);
    }
    return numbers;
  }

  /** The int that {@code text} is; empty when it is none. */
  static OptionalInt integer(String text) {
    if (!INTEGER.matcher(text).matches()) {
      return OptionalInt.empty();
    }
    long number = Long.parseLong(text);
    return number == (int) number ? OptionalInt.of((int) number) : OptionalInt.empty();
  }
}
