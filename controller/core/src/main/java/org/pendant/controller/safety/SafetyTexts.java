package org.pendant.controller.safety;

import org.pendant.text.Texts;

/** What this package says to people. */
final class SafetyTexts {
  private static final Texts TEXTS = Texts.english(SafetyTexts.class);

  private SafetyTexts() {}

  /** The text of a key of {@code texts/controller.safety.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
