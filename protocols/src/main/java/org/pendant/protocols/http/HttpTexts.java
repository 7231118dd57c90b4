package org.pendant.protocols.http;

import org.pendant.text.Texts;

/** What this package says to people. */
final class HttpTexts {
  private static final Texts TEXTS = Texts.english(HttpTexts.class);

  private HttpTexts() {}

  /** The text of a key of {@code texts/protocols.http.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
