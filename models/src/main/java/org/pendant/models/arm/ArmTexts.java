package org.pendant.models.arm;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ArmTexts {
  private static final Texts TEXTS = Texts.english(ArmTexts.class);

  private ArmTexts() {}

  /** The text of a key of {@code texts/models.arm.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
