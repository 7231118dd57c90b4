package org.pendant.controller.rtde;

import org.pendant.text.Texts;

/** What this package says to people. */
final class RtdeInputTexts {
  private static final Texts TEXTS = Texts.english(RtdeInputTexts.class);

  private RtdeInputTexts() {}

  /** The text of a key of {@code texts/controller.rtde.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
