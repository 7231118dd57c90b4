package org.pendant.project.program;

import java.util.OptionalDouble;
import java.util.regex.Pattern;

/** Number as people and files write it, such as {@code -1.5} or {@code 2e3}. */
final class PlainNumber {
  private static final Pattern NUMBER =
      Pattern.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?");

  private PlainNumber() {}

  /** The number that a text is, blanks around it aside; empty if it is anything else. */
  static OptionalDouble of(String text) {
    String number = text.strip();
    return NUMBER.matcher(number).matches()
        ? OptionalDouble.of(Double.parseDouble(number))
        : OptionalDouble.empty();
  }
}
