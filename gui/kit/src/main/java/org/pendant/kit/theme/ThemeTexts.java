package org.pendant.kit.theme;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ThemeTexts {
  private static final Texts TEXTS = Texts.of(ThemeTexts.class);

  private ThemeTexts() {}

  /** The text of a key of {@code texts/kit.theme.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
