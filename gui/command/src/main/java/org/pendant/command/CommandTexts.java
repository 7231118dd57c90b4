package org.pendant.command;

import org.pendant.command.text.CommandLanguage;
import org.pendant.text.Texts;

/** What this package says to people. */
final class CommandTexts {
  private static final Texts TEXTS = CommandLanguage.texts(CommandTexts.class);

  private CommandTexts() {}

  /** The text of a key of {@code texts/command.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
