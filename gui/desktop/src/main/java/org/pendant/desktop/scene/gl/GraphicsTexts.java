package org.pendant.desktop.scene.gl;

import org.pendant.text.Texts;

/** What this package says to people. */
final class GraphicsTexts {
  private static final Texts TEXTS = Texts.english(GraphicsTexts.class);

  private GraphicsTexts() {}

  /** The text of a key of {@code texts/desktop.scene.gl.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
