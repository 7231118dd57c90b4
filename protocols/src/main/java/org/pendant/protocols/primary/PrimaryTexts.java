package org.pendant.protocols.primary;

import org.pendant.text.Texts;

/** What this package says to people. */
final class PrimaryTexts {
  private static final Texts TEXTS = Texts.english(PrimaryTexts.class);

  private PrimaryTexts() {}

  /** The text of a key of {@code texts/protocols.primary.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
