package org.pendant.controller.disk;

import org.pendant.text.Texts;

/** What this package says to people. */
final class DiskTexts {
  private static final Texts TEXTS = Texts.english(DiskTexts.class);

  private DiskTexts() {}

  /** The text of a key of {@code texts/controller.disk.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
