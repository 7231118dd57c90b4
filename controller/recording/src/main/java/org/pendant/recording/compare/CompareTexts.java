package org.pendant.recording.compare;

import org.pendant.text.Texts;

/** What this package says to people. */
final class CompareTexts {
  private static final Texts TEXTS = Texts.english(CompareTexts.class);

  private CompareTexts() {}

  /** The text of a key of {@code texts/recording.compare.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
