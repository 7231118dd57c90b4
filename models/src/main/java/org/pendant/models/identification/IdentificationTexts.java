package org.pendant.models.identification;

import org.pendant.text.Texts;

/** What this package says to people. */
final class IdentificationTexts {
  private static final Texts TEXTS = Texts.english(IdentificationTexts.class);

  private IdentificationTexts() {}

  /** The text of a key of {@code texts/models.identification.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
