package org.pendant.controller.device.camera;

import org.pendant.text.Texts;

/** What this package says to people. */
final class CameraTexts {
  private static final Texts TEXTS = Texts.english(CameraTexts.class);

  private CameraTexts() {}

  /** The text of a key of {@code texts/controller.device.camera.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
