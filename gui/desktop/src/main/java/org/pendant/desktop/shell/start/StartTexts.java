package org.pendant.desktop.shell.start;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class StartTexts {
  private static final Texts TEXTS = Texts.of(StartTexts.class, Messages::shown);

  private StartTexts() {}

  /** The text of a key of {@code texts/desktop.shell.start.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
