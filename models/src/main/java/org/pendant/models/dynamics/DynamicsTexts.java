package org.pendant.models.dynamics;

import org.pendant.text.Texts;

/** What this package says to people. */
final class DynamicsTexts {
  private static final Texts TEXTS = Texts.english(DynamicsTexts.class);

  private DynamicsTexts() {}

  /** The text of a key of {@code texts/models.dynamics.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
