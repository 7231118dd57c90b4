package org.pendant.controller.builtin;

import org.pendant.text.Texts;

/** What this package says to people. */
final class BuiltinTexts {
  private static final Texts TEXTS = Texts.english(BuiltinTexts.class);

  private BuiltinTexts() {}

  /** The text of a key of {@code texts/controller.builtin.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
