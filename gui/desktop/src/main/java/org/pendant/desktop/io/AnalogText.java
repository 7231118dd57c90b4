package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

import java.util.Locale;
import org.pendant.controller.io.AnalogDomain;

/** Analog text: values as people read and type them: mA and V. */
final class AnalogText {
  private AnalogText() {}

  /** The unit on the screen. */
  static String unit(AnalogDomain domain) {
    return switch (domain) {
      case CURRENT -> "mA";
      case VOLTAGE -> "V";
    };
  }

  private static double scale(AnalogDomain domain) {
    return switch (domain) {
      case CURRENT -> 1000;
      case VOLTAGE -> 1;
    };
  }

  /**
   * The number before the unit.
   *
   * @param value A or V as the domain says
   */
  static String of(double value, AnalogDomain domain) {
    return String.format(Locale.ROOT, "%.2f", value * scale(domain));
  }

  /**
   * Reads what the user typed, with the unit or without.
   *
   * @return A or V as the domain says, within its range
   * @throws IllegalArgumentException with a sentence for people if it is not such a value
   */
  static double parse(String text, AnalogDomain domain) {
    String number = text.strip().replace(',', '.');
    if (number.endsWith(unit(domain))) {
      number = number.substring(0, number.length() - unit(domain).length()).strip();
    }
    double scale = scale(domain);
    try {
      double value = Double.parseDouble(number) / scale;
      if (value >= domain.low() && value <= domain.high()) {
        return value;
      }
    } catch (NumberFormatException e) {
      // the message below says what is wrong with it
    }
    throw new IllegalArgumentException(
        String.format(
            Locale.ROOT,
            text("analogMustBe"),
            text.strip(),
            domain.low() * scale,
            domain.high() * scale,
            unit(domain)));
  }
}
