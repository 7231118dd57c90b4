package org.pendant.language.service;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ServiceTexts {
  private static final Texts TEXTS = Texts.english(ServiceTexts.class);

  private ServiceTexts() {}

  /** The text of a key of {@code texts/language.service.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
