package org.pendant.controller.message;

import org.pendant.text.Texts;

/** What this package says to people. */
final class MessageTexts {
  private static final Texts TEXTS = Texts.english(MessageTexts.class);

  private MessageTexts() {}

  /** The text of a key of {@code texts/controller.message.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
