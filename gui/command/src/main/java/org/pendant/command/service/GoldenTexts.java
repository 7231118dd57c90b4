package org.pendant.command.service;

import org.pendant.text.Texts;

/** What this package says to people. */
final class GoldenTexts {
  private static final Texts TEXTS = Texts.english(GoldenTexts.class);

  private GoldenTexts() {}

  /** The text of a key of {@code texts/command.service.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
