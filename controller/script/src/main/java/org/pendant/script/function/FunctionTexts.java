package org.pendant.script.function;

import org.pendant.text.Texts;

/** What this package says to people. */
final class FunctionTexts {
  private static final Texts TEXTS = Texts.english(FunctionTexts.class);

  private FunctionTexts() {}

  /** The text of a key of {@code texts/script.function.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
