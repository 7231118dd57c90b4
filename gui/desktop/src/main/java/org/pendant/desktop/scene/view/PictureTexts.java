package org.pendant.desktop.scene.view;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class PictureTexts {
  private static final Texts TEXTS = Texts.of(PictureTexts.class, Messages::shown);

  private PictureTexts() {}

  /** The text of a key of {@code texts/desktop.scene.view.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
