package org.pendant.models.calibration;

import java.util.Optional;
import java.util.regex.Pattern;

/** Numbers as files of calibrations write them. */
final class CalibrationNumbers {
  private static final Pattern DECIMAL =
      Pattern.compile("[-+]?([0-9]+(\\.[0-9]*)?|\\.[0-9]+)([eE][-+]?[0-9]{1,4})?");
  private static final Pattern WHOLE = Pattern.compile("(0[xX][0-9a-fA-F]{1,8}|-?[0-9]{1,10})");
  private static final long MAX_UNSIGNED = 0xFFFF_FFFFL;

  private CalibrationNumbers() {}

  /** A finite decimal number; empty if it is none. */
  static Optional<Double> number(String text) {
    return DECIMAL.matcher(text).matches()
        ? Optional.of(Double.parseDouble(text)).filter(Double::isFinite)
        : Optional.empty();
  }

  /** A number of 32 bits with a sign or without, decimal or from {@code 0x} on in hexadecimal. */
  static Optional<Integer> word(String text) {
    if (!WHOLE.matcher(text).matches()) {
      return Optional.empty();
    }
    long value = Long.decode(text.startsWith("0x") || text.startsWith("0X") ? text : plain(text));
    return value >= Integer.MIN_VALUE && value <= MAX_UNSIGNED
        ? Optional.of((int) value)
        : Optional.empty();
  }

  /** Without the zeros in front, which would make it an octal number. */
  private static String plain(String text) {
    return Long.toString(Long.parseLong(text));
  }
}
