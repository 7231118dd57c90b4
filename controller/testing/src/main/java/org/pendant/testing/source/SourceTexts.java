package org.pendant.testing.source;

import org.pendant.text.Texts;

/** What this package says to people. */
final class SourceTexts {
  private static final Texts TEXTS = Texts.english(SourceTexts.class);

  private SourceTexts() {}

  /** The text of a key of {@code texts/testing.source.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
