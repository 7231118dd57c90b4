package org.pendant.desktop.debug;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class DebugTexts {
  private static final Texts TEXTS = Texts.of(DebugTexts.class, Messages::shown);

  private DebugTexts() {}

  /** The text of a key of {@code texts/desktop.debug.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
