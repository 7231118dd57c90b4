package org.pendant.protocols.interpreter;

import org.pendant.text.Texts;

/** What this package says to people. */
final class InterpreterTexts {
  private static final Texts TEXTS = Texts.english(InterpreterTexts.class);

  private InterpreterTexts() {}

  /** The text of a key of {@code texts/protocols.interpreter.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
