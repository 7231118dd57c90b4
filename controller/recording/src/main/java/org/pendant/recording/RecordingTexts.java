package org.pendant.recording;

import org.pendant.text.Texts;

/** What this package says to people. */
final class RecordingTexts {
  private static final Texts TEXTS = Texts.english(RecordingTexts.class);

  private RecordingTexts() {}

  /** The text of a key of {@code texts/recording.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
