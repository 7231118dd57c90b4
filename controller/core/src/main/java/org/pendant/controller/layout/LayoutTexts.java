package org.pendant.controller.layout;

import org.pendant.text.Texts;

/** What this package says to people. */
final class LayoutTexts {
  private static final Texts TEXTS = Texts.english(LayoutTexts.class);

  private LayoutTexts() {}

  /** The text of a key of {@code texts/controller.layout.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
