package org.pendant.desktop.unit;

import org.pendant.text.Texts;

/** What this package says to people. */
final class UnitTexts {
  private static final Texts TEXTS = Texts.of(UnitTexts.class);

  private UnitTexts() {}

  /** The text of a key of {@code texts/desktop.unit.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
