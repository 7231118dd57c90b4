package org.pendant.controller.device;

import org.pendant.text.Texts;

/** What this package says to people. */
final class DeviceTexts {
  private static final Texts TEXTS = Texts.english(DeviceTexts.class);

  private DeviceTexts() {}

  /** The text of a key of {@code texts/controller.device.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
