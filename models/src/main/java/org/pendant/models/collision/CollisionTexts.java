package org.pendant.models.collision;

import org.pendant.text.Texts;

/** What this package says to people. */
final class CollisionTexts {
  private static final Texts TEXTS = Texts.english(CollisionTexts.class);

  private CollisionTexts() {}

  /** The text of a key of {@code texts/models.collision.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
