package org.pendant.controller.quantity;

import org.pendant.text.Texts;

/** What this package says to people. */
final class QuantityTexts {
  private static final Texts TEXTS = Texts.english(QuantityTexts.class);

  private QuantityTexts() {}

  /** The text of a key of {@code texts/controller.quantity.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
