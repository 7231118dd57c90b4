package org.pendant.controller.wire;

import org.pendant.text.Texts;

/** What this package says to people. */
final class SignalNameTexts {
  private static final Texts TEXTS = Texts.english(SignalNameTexts.class);

  private SignalNameTexts() {}

  /** The text of a key of {@code texts/controller.wire.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
