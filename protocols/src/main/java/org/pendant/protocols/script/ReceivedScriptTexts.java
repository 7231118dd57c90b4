package org.pendant.protocols.script;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ReceivedScriptTexts {
  private static final Texts TEXTS = Texts.english(ReceivedScriptTexts.class);

  private ReceivedScriptTexts() {}

  /** The text of a key of {@code texts/protocols.script.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
