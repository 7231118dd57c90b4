package org.pendant.project.program.urp;

import org.pendant.text.Texts;

/** What this package says to people. */
final class UrpProgramTexts {
  private static final Texts TEXTS = Texts.english(UrpProgramTexts.class);

  private UrpProgramTexts() {}

  /** The text of a key of {@code texts/project.program.urp.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
