package org.pendant.recording.fit;

import org.pendant.text.Texts;

/** What this package says to people. */
final class FitTexts {
  private static final Texts TEXTS = Texts.english(FitTexts.class);

  private FitTexts() {}

  /** The text of a key of {@code texts/recording.fit.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
