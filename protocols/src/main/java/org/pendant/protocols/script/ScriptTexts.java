package org.pendant.protocols.script;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ScriptTexts {
  private static final Texts TEXTS = Texts.english(ScriptTexts.class);

  private ScriptTexts() {}

  /** The text of a key of {@code texts/protocols.script.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
