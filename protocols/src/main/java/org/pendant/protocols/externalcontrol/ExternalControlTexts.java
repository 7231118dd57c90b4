package org.pendant.protocols.externalcontrol;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ExternalControlTexts {
  private static final Texts TEXTS = Texts.english(ExternalControlTexts.class);

  private ExternalControlTexts() {}

  /**
   * The text of a key of {@code texts/protocols.externalcontrol.properties}, filled with values.
   */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
