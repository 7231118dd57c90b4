package org.pendant.protocols.device;

import org.pendant.text.Texts;

/** What this package says to people. */
final class DeviceServerTexts {
  private static final Texts TEXTS = Texts.english(DeviceServerTexts.class);

  private DeviceServerTexts() {}

  /** The text of a key of {@code texts/protocols.device.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
