package org.pendant.project.program;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ProgramTreeTexts {
  private static final Texts TEXTS = Texts.english(ProgramTreeTexts.class);

  private ProgramTreeTexts() {}

  /** The text of a key of {@code texts/project.program.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
