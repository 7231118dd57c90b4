package org.pendant.project.program.text;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ProgramLineTexts {
  private static final Texts TEXTS = Texts.english(ProgramLineTexts.class);

  private ProgramLineTexts() {}

  /** The text of a key of {@code texts/project.program.text.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
