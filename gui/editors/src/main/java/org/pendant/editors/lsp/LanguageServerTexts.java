package org.pendant.editors.lsp;

import org.pendant.text.Texts;

/** What this package says to people. */
final class LanguageServerTexts {
  private static final Texts TEXTS = Texts.english(LanguageServerTexts.class);

  private LanguageServerTexts() {}

  /** The text of a key of {@code texts/editors.lsp.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
