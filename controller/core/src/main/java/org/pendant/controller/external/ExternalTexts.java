package org.pendant.controller.external;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ExternalTexts {
  private static final Texts TEXTS = Texts.english(ExternalTexts.class);

  private ExternalTexts() {}

  /** The text of a key of {@code texts/controller.external.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
