package org.pendant.desktop.shell.chrome;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class ChromeTexts {
  private static final Texts TEXTS = Texts.of(ChromeTexts.class, Messages::shown);

  private ChromeTexts() {}

  /** The text of a key of {@code texts/desktop.shell.chrome.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
