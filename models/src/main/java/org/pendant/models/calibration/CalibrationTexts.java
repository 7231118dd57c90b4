package org.pendant.models.calibration;

import org.pendant.text.Texts;

/** What this package says to people. */
final class CalibrationTexts {
  private static final Texts TEXTS = Texts.english(CalibrationTexts.class);

  private CalibrationTexts() {}

  /** The text of a key of {@code texts/models.calibration.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
