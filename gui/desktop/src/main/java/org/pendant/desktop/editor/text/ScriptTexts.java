package org.pendant.desktop.editor.text;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class ScriptTexts {
  private static final Texts TEXTS = Texts.of(ScriptTexts.class, Messages::shown);

  private ScriptTexts() {}

  /** The text of a key of {@code texts/desktop.editor.text.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
