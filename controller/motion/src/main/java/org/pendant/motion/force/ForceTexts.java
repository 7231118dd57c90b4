package org.pendant.motion.force;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ForceTexts {
  private static final Texts TEXTS = Texts.english(ForceTexts.class);

  private ForceTexts() {}

  /** The text of a key of {@code texts/motion.force.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
