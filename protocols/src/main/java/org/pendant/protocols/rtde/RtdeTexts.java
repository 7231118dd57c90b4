package org.pendant.protocols.rtde;

import org.pendant.text.Texts;

/** What this package says to people. */
final class RtdeTexts {
  private static final Texts TEXTS = Texts.english(RtdeTexts.class);

  private RtdeTexts() {}

  /** The text of a key of {@code texts/protocols.rtde.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
