package org.pendant.desktop.help;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class HelpViewTexts {
  private static final Texts TEXTS = Texts.of(HelpViewTexts.class, Messages::shown);

  private HelpViewTexts() {}

  /** The text of a key of {@code texts/desktop.help.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
