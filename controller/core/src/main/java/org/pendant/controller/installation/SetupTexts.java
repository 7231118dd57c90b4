package org.pendant.controller.installation;

import org.pendant.text.Texts;

/** What this package says to people. */
final class SetupTexts {
  private static final Texts TEXTS = Texts.english(SetupTexts.class);

  private SetupTexts() {}

  /** The text of a key of {@code texts/controller.installation.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
