package org.pendant.editors.wire;

import org.pendant.text.Texts;

/** What this package says to people. */
final class FrameTexts {
  private static final Texts TEXTS = Texts.english(FrameTexts.class);

  private FrameTexts() {}

  /** The text of a key of {@code texts/editors.wire.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
