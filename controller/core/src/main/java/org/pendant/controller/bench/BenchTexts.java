package org.pendant.controller.bench;

import org.pendant.text.Texts;

/** What this package says to people. */
final class BenchTexts {
  private static final Texts TEXTS = Texts.english(BenchTexts.class);

  private BenchTexts() {}

  /** The text of a key of {@code texts/controller.bench.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
