package org.pendant.editors.lsp.text;

import org.pendant.text.Texts;

/** What this package says to people. */
final class DocumentTexts {
  private static final Texts TEXTS = Texts.english(DocumentTexts.class);

  private DocumentTexts() {}

  /** The text of a key of {@code texts/editors.lsp.text.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
