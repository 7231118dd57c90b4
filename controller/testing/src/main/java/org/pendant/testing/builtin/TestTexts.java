package org.pendant.testing.builtin;

import org.pendant.text.Texts;

/** What this package says to people. */
final class TestTexts {
  private static final Texts TEXTS = Texts.english(TestTexts.class);

  private TestTexts() {}

  /** The text of a key of {@code texts/testing.builtin.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
