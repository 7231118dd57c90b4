package org.pendant.testing.coverage;

import org.pendant.text.Texts;

/** What this package says to people. */
final class CoverageTexts {
  private static final Texts TEXTS = Texts.english(CoverageTexts.class);

  private CoverageTexts() {}

  /** The text of a key of {@code texts/testing.coverage.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
