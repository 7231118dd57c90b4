package org.pendant.motion.toolpath;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ToolpathTexts {
  private static final Texts TEXTS = Texts.english(ToolpathTexts.class);

  private ToolpathTexts() {}

  /** The text of a key of {@code texts/motion.toolpath.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
