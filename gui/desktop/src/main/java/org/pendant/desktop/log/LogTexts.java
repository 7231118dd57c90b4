package org.pendant.desktop.log;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class LogTexts {
  private static final Texts TEXTS = Texts.of(LogTexts.class, Messages::shown);

  private LogTexts() {}

  /** The text of a key of {@code texts/desktop.log.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
