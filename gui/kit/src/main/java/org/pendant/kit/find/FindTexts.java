package org.pendant.kit.find;

import org.pendant.text.Texts;

/** What this package says to people. */
final class FindTexts {
  private static final Texts TEXTS = Texts.of(FindTexts.class);

  private FindTexts() {}

  /** The text of a key of {@code texts/kit.find.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
