package org.pendant.kit.background;

import org.pendant.text.Texts;

/** What this package says to people. */
final class BackgroundTexts {
  private static final Texts TEXTS = Texts.of(BackgroundTexts.class);

  private BackgroundTexts() {}

  /** The text of a key of {@code texts/kit.background.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
