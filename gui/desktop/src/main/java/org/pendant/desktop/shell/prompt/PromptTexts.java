package org.pendant.desktop.shell.prompt;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class PromptTexts {
  private static final Texts TEXTS = Texts.of(PromptTexts.class, Messages::shown);

  private PromptTexts() {}

  /** The text of a key of {@code texts/desktop.shell.prompt.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
