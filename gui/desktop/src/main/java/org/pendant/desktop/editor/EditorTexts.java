package org.pendant.desktop.editor;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class EditorTexts {
  private static final Texts TEXTS = Texts.of(EditorTexts.class, Messages::shown);

  private EditorTexts() {}

  /** The text of a key of {@code texts/desktop.editor.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
