package org.pendant.desktop.move;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Collectors;

/** Saved numbers: numbers as settings keep them: with full precision, blanks between. */
final class SavedNumbers {
  private SavedNumbers() {}

  static String text(double... numbers) {
    return Arrays.stream(numbers).mapToObj(Double::toString).collect(Collectors.joining(" "));
  }

  /** As many finite numbers as wanted; empty if the text has others. */
  static Optional<double[]> read(String text, int count) {
    String[] parts = text.strip().split("\\s+", -1);
    double[] numbers = new double[parts.length];
    for (int i = 0; i < parts.length; i++) {
      try {
        numbers[i] = Double.parseDouble(parts[i]);
      } catch (NumberFormatException e) {
        // settings can be edited by hand
        return Optional.empty();
      }
    }
    return numbers.length == count && Arrays.stream(numbers).allMatch(Double::isFinite)
        ? Optional.of(numbers)
        : Optional.empty();
  }
}
