package org.pendant.sweep.run;

import org.pendant.text.Texts;

/** What this package says to people. */
final class SweepRunTexts {
  private static final Texts TEXTS = Texts.english(SweepRunTexts.class);

  private SweepRunTexts() {}

  /** The text of a key of {@code texts/sweep.run.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
