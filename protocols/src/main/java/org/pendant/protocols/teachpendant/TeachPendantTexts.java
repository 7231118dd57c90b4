package org.pendant.protocols.teachpendant;

import org.pendant.text.Texts;

/** What this package says to people. */
final class TeachPendantTexts {
  private static final Texts TEXTS = Texts.english(TeachPendantTexts.class);

  private TeachPendantTexts() {}

  /** The text of a key of {@code texts/protocols.teachpendant.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
