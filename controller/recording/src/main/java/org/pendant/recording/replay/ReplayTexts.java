package org.pendant.recording.replay;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ReplayTexts {
  private static final Texts TEXTS = Texts.english(ReplayTexts.class);

  private ReplayTexts() {}

  /** The text of a key of {@code texts/recording.replay.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
