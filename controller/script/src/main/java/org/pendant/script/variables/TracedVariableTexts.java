package org.pendant.script.variables;

import org.pendant.text.Texts;

/** What this package says to people. */
final class TracedVariableTexts {
  private static final Texts TEXTS = Texts.english(TracedVariableTexts.class);

  private TracedVariableTexts() {}

  /** The text of a key of {@code texts/script.variables.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
