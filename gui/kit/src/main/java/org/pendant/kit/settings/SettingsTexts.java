package org.pendant.kit.settings;

import org.pendant.text.Texts;

/** What this package says to people. */
final class SettingsTexts {
  private static final Texts TEXTS = Texts.of(SettingsTexts.class);

  private SettingsTexts() {}

  /** The text of a key of {@code texts/kit.settings.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
