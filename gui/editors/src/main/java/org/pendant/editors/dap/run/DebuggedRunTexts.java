package org.pendant.editors.dap.run;

import org.pendant.text.Texts;

/** What this package says to people. */
final class DebuggedRunTexts {
  private static final Texts TEXTS = Texts.english(DebuggedRunTexts.class);

  private DebuggedRunTexts() {}

  /** The text of a key of {@code texts/editors.dap.run.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
