package org.pendant.controller.eip;

import org.pendant.text.Texts;

/** What this package says to people. */
final class AssemblyDataTexts {
  private static final Texts TEXTS = Texts.english(AssemblyDataTexts.class);

  private AssemblyDataTexts() {}

  /** The text of a key of {@code texts/controller.eip.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
