package org.pendant.language.parse;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ParseTexts {
  private static final Texts TEXTS = Texts.english(ParseTexts.class);

  private ParseTexts() {}

  /** The text of a key of {@code texts/language.parse.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
