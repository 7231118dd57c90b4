package org.pendant.desktop.plot;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Scale: an axis with round numbers.
 *
 * @param low its lower end
 * @param high its upper end, above the lower one
 * @param step from one number to the next
 */
public record Scale(double low, double high, double step) {

  /** An axis from {@code low} to {@code high} exactly, with about {@code most} numbers at most. */
  static Scale exact(double low, double high, int most) {
    return new Scale(low, high, roundStep((high - low) / Math.max(1, most)));
  }

  /** An axis that has {@code low} and {@code high} and ends at round numbers. */
  public static Scale around(double low, double high, int most) {
    double margin = high - low < 1e-9 * Math.max(1, Math.abs(high)) ? spread(high) : 0;
    double step = roundStep((high - low + 2 * margin) / Math.max(1, most));
    return new Scale(
        Math.floor((low - margin) / step) * step, Math.ceil((high + margin) / step) * step, step);
  }

  /** Half the height of an axis whose values are all the same. */
  private static double spread(double value) {
    return Math.max(0.5, 0.01 * Math.abs(value));
  }

  /** The smallest of 1, 2 and 5 times a power of ten that is at least {@code rough}. */
  static double roundStep(double rough) {
    double power = Math.pow(10, Math.floor(Math.log10(rough)));
    double share = rough / power;
    double round = share <= 1.0000001 ? 1 : share <= 2.0000001 ? 2 : share <= 5.0000001 ? 5 : 10;
    return round * power;
  }

  /** The round numbers on it. */
  public List<Double> ticks() {
    List<Double> ticks = new ArrayList<>();
    for (long i = (long) Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) {
      ticks.add(i * step);
    }
    return ticks;
  }

  /** A number on it as text, with the digits that its step needs. */
  public String text(double value) {
    int digits = (int) Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    return String.format(Locale.ROOT, "%." + digits + "f", value + 0.0);
  }

  /** Where a value is, 0 at the lower end to 1 at the upper one. */
  double placeOf(double value) {
    return (value - low) / (high - low);
  }
}
