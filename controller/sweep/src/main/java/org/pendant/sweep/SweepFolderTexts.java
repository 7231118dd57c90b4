package org.pendant.sweep;

import org.pendant.text.Texts;

/** What this package says to people. */
final class SweepFolderTexts {
  private static final Texts TEXTS = Texts.english(SweepFolderTexts.class);

  private SweepFolderTexts() {}

  /** The text of a key of {@code texts/sweep.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
