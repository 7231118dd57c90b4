package org.pendant.command;

import org.pendant.command.text.SpokenTexts;

/** What this package says to people. */
final class CommandTexts {
  private static final SpokenTexts TEXTS = new SpokenTexts(CommandTexts.class);

  private CommandTexts() {}

  /** The text of a key of {@code texts/command.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
