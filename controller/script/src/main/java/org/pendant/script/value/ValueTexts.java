package org.pendant.script.value;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ValueTexts {
  private static final Texts TEXTS = Texts.english(ValueTexts.class);

  private ValueTexts() {}

  /** The text of a key of {@code texts/script.value.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
