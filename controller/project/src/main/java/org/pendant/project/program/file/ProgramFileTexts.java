package org.pendant.project.program.file;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ProgramFileTexts {
  private static final Texts TEXTS = Texts.english(ProgramFileTexts.class);

  private ProgramFileTexts() {}

  /** The text of a key of {@code texts/project.program.file.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
