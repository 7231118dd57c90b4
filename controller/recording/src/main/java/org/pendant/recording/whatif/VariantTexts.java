package org.pendant.recording.whatif;

import org.pendant.text.Texts;

/** What this package says to people. */
final class VariantTexts {
  private static final Texts TEXTS = Texts.english(VariantTexts.class);

  private VariantTexts() {}

  /** The text of a key of {@code texts/recording.whatif.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
