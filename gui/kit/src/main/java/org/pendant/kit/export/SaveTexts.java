package org.pendant.kit.export;

import org.pendant.text.Texts;

/** What this package says to people. */
final class SaveTexts {
  private static final Texts TEXTS = Texts.of(SaveTexts.class);

  private SaveTexts() {}

  /** The text of a key of {@code texts/kit.export.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
