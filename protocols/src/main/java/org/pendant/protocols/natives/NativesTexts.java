package org.pendant.protocols.natives;

import org.pendant.text.Texts;

/** What this package says to people. */
final class NativesTexts {
  private static final Texts TEXTS = Texts.english(NativesTexts.class);

  private NativesTexts() {}

  /** The text of a key of {@code texts/protocols.natives.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
