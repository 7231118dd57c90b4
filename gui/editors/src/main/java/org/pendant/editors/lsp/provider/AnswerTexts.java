package org.pendant.editors.lsp.provider;

import org.pendant.text.Texts;

/** What this package says to people. */
final class AnswerTexts {
  private static final Texts TEXTS = Texts.english(AnswerTexts.class);

  private AnswerTexts() {}

  /** The text of a key of {@code texts/editors.lsp.provider.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
