package org.pendant.language.signature;

import org.pendant.text.Texts;

/** What this package says to people. */
final class SignatureTexts {
  private static final Texts TEXTS = Texts.english(SignatureTexts.class);

  private SignatureTexts() {}

  /** The text of a key of {@code texts/language.signature.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
