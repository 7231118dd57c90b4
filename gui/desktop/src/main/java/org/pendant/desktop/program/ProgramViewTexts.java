package org.pendant.desktop.program;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class ProgramViewTexts {
  private static final Texts TEXTS = Texts.of(ProgramViewTexts.class, Messages::shown);

  private ProgramViewTexts() {}

  /** The text of a key of {@code texts/desktop.program.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
