package org.pendant.controller.world;

import org.pendant.text.Texts;

/** What this package says to people. */
final class WorldTexts {
  private static final Texts TEXTS = Texts.english(WorldTexts.class);

  private WorldTexts() {}

  /** The text of a key of {@code texts/controller.world.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
