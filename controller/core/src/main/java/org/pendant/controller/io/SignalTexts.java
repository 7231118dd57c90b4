package org.pendant.controller.io;

import org.pendant.text.Texts;

/** What this package says to people. */
final class SignalTexts {
  private static final Texts TEXTS = Texts.english(SignalTexts.class);

  private SignalTexts() {}

  /** The text of a key of {@code texts/controller.io.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
