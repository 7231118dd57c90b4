package org.pendant.sweep.engine;

import org.pendant.text.Texts;

/** What this package says to people. */
final class EngineTexts {
  private static final Texts TEXTS = Texts.english(EngineTexts.class);

  private EngineTexts() {}

  /** The text of a key of {@code texts/sweep.engine.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
