package org.pendant.script.debug;

import org.pendant.text.Texts;

/** What this package says to people. */
final class DebuggerTexts {
  private static final Texts TEXTS = Texts.english(DebuggerTexts.class);

  private DebuggerTexts() {}

  /** The text of a key of {@code texts/script.debug.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
