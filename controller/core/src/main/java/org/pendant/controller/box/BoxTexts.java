package org.pendant.controller.box;

import org.pendant.text.Texts;

/** What this package says to people. */
final class BoxTexts {
  private static final Texts TEXTS = Texts.english(BoxTexts.class);

  private BoxTexts() {}

  /** The text of a key of {@code texts/controller.box.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
