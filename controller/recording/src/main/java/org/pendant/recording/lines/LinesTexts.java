package org.pendant.recording.lines;

import org.pendant.text.Texts;

/** What this package says to people. */
final class LinesTexts {
  private static final Texts TEXTS = Texts.english(LinesTexts.class);

  private LinesTexts() {}

  /** The text of a key of {@code texts/recording.lines.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
