package org.pendant.desktop.io;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class IoTexts {
  private static final Texts TEXTS = Texts.of(IoTexts.class, Messages::shown);

  private IoTexts() {}

  /** The text of a key of {@code texts/desktop.io.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
