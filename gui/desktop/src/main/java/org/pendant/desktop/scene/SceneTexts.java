package org.pendant.desktop.scene;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class SceneTexts {
  private static final Texts TEXTS = Texts.of(SceneTexts.class, Messages::shown);

  private SceneTexts() {}

  /** The text of a key of {@code texts/desktop.scene.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
