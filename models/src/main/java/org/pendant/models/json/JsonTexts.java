package org.pendant.models.json;

import org.pendant.text.Texts;

/** What this package says to people. */
final class JsonTexts {
  private static final Texts TEXTS = Texts.english(JsonTexts.class);

  private JsonTexts() {}

  /** The text of a key of {@code texts/models.json.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
