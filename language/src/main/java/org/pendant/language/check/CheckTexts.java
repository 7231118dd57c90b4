package org.pendant.language.check;

import org.pendant.text.Texts;

/** What this package says to people. */
final class CheckTexts {
  private static final Texts TEXTS = Texts.english(CheckTexts.class);

  private CheckTexts() {}

  /** The text of a key of {@code texts/language.check.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
