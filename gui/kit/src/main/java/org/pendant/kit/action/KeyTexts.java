package org.pendant.kit.action;

import org.pendant.text.Texts;

/** What this package says to people. */
final class KeyTexts {
  private static final Texts TEXTS = Texts.of(KeyTexts.class);

  private KeyTexts() {}

  /** The text of a key of {@code texts/kit.action.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
