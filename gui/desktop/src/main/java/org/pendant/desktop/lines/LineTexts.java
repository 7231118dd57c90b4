package org.pendant.desktop.lines;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class LineTexts {
  private static final Texts TEXTS = Texts.of(LineTexts.class, Messages::shown);

  private LineTexts() {}

  /** The text of a key of {@code texts/desktop.lines.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
