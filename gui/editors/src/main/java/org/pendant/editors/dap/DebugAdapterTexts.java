package org.pendant.editors.dap;

import org.pendant.text.Texts;

/** What this package says to people. */
final class DebugAdapterTexts {
  private static final Texts TEXTS = Texts.english(DebugAdapterTexts.class);

  private DebugAdapterTexts() {}

  /** The text of a key of {@code texts/editors.dap.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
