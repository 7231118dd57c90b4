package org.pendant.protocols.eip;

import org.pendant.text.Texts;

/** What this package says to people. */
final class EipTexts {
  private static final Texts TEXTS = Texts.english(EipTexts.class);

  private EipTexts() {}

  /** The text of a key of {@code texts/protocols.eip.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
