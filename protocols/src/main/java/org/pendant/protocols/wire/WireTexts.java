package org.pendant.protocols.wire;

import org.pendant.text.Texts;

/** What this package says to people. */
final class WireTexts {
  private static final Texts TEXTS = Texts.english(WireTexts.class);

  private WireTexts() {}

  /** The text of a key of {@code texts/protocols.wire.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
