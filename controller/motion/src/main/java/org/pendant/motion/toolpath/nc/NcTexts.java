package org.pendant.motion.toolpath.nc;

import org.pendant.text.Texts;

/** What this package says to people. */
final class NcTexts {
  private static final Texts TEXTS = Texts.english(NcTexts.class);

  private NcTexts() {}

  /** The text of a key of {@code texts/motion.toolpath.nc.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
