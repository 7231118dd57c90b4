package org.pendant.protocols.egress;

import org.pendant.text.Texts;

/** What this package says to people. */
final class EgressTexts {
  private static final Texts TEXTS = Texts.english(EgressTexts.class);

  private EgressTexts() {}

  /** The text of a key of {@code texts/protocols.egress.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
