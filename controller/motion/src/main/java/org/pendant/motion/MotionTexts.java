package org.pendant.motion;

import org.pendant.text.Texts;

/** What this package says to people. */
final class MotionTexts {
  private static final Texts TEXTS = Texts.english(MotionTexts.class);

  private MotionTexts() {}

  /** The text of a key of {@code texts/motion.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
