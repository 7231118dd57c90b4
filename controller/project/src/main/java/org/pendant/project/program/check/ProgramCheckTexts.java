package org.pendant.project.program.check;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ProgramCheckTexts {
  private static final Texts TEXTS = Texts.english(ProgramCheckTexts.class);

  private ProgramCheckTexts() {}

  /** The text of a key of {@code texts/project.program.check.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
