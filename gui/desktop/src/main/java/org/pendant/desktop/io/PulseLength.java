package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

/**
 * Pulse length: how long a pulse lasts.
 *
 * @param seconds robot time, s
 */
record PulseLength(double seconds) {
  /** As long as a press on a button. */
  static final PulseLength STANDARD = new PulseLength(0.5);

  /**
   * Checks the length.
   *
   * @throws IllegalArgumentException if it is not 0.01 to 60 s
   */
  PulseLength {
    if (!(seconds >= 0.01 && seconds <= 60)) {
      throw new IllegalArgumentException(text("pulseOutside", seconds));
    }
  }

  /**
   * Reads what the user typed.
   *
   * @throws IllegalArgumentException with a sentence for people if it is not a length
   */
  static PulseLength parse(String text) {
    double seconds;
    try {
      seconds = Double.parseDouble(text.strip().replace(',', '.'));
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException(text("pulseNotNumber", text.strip()), e);
    }
    return new PulseLength(seconds);
  }
}
