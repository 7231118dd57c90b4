package org.pendant.editors.dap.look;

import org.pendant.text.Texts;

/** What this package says to people. */
final class LookTexts {
  private static final Texts TEXTS = Texts.english(LookTexts.class);

  private LookTexts() {}

  /** The text of a key of {@code texts/editors.dap.look.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
