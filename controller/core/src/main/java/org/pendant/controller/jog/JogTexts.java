package org.pendant.controller.jog;

import org.pendant.text.Texts;

/** What this package says to people. */
final class JogTexts {
  private static final Texts TEXTS = Texts.english(JogTexts.class);

  private JogTexts() {}

  /** The text of a key of {@code texts/controller.jog.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
