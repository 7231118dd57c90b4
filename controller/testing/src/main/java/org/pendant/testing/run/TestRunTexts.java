package org.pendant.testing.run;

import org.pendant.text.Texts;

/** What this package says to people. */
final class TestRunTexts {
  private static final Texts TEXTS = Texts.english(TestRunTexts.class);

  private TestRunTexts() {}

  /** The text of a key of {@code texts/testing.run.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
