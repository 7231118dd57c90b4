package org.pendant.desktop.plot;

import java.util.Locale;

/** Readout: values as legends show them. */
final class Readout {
  private Readout() {}

  /** A value with its unit, four digits behind the point at most. */
  static String of(ChartQuantity quantity, double value) {
    return quantity.digital() ? level(value) : number(value) + unit(quantity);
  }

  /** The values at both cursors and what they differ by. */
  static String between(ChartQuantity quantity, double a, double b) {
    if (quantity.digital()) {
      return "A " + level(a) + "  B " + level(b);
    }
    return "A " + number(a) + "  B " + number(b) + "  \u0394 " + number(b - a) + unit(quantity);
  }

  private static String unit(ChartQuantity quantity) {
    boolean close = quantity.unit().isEmpty() || quantity.unit().equals("\u00b0");
    return close ? quantity.unit() : " " + quantity.unit();
  }

  private static String level(double value) {
    return Double.isNaN(value) ? "\u2013" : value == 0 ? "low" : "high";
  }

  private static String number(double value) {
    if (Double.isNaN(value)) {
      return "\u2013";
    }
    int digits = Math.abs(value) >= 100 ? 1 : Math.abs(value) >= 1 ? 2 : 3;
    double scale = Math.pow(10, digits);
    double rounded = Math.round(value * scale) / scale;
    return String.format(Locale.ROOT, "%." + digits + "f", rounded == 0 ? 0.0 : rounded);
  }
}
