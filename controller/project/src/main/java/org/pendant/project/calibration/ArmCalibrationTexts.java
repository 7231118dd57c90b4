package org.pendant.project.calibration;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ArmCalibrationTexts {
  private static final Texts TEXTS = Texts.english(ArmCalibrationTexts.class);

  private ArmCalibrationTexts() {}

  /** The text of a key of {@code texts/project.calibration.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
