package org.pendant.desktop.shell;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class ShellTexts {
  private static final Texts TEXTS = Texts.of(ShellTexts.class, Messages::shown);

  private ShellTexts() {}

  /** The text of a key of {@code texts/desktop.shell.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
