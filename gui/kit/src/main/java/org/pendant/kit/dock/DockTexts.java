package org.pendant.kit.dock;

import org.pendant.text.Texts;

/** What this package says to people. */
final class DockTexts {
  private static final Texts TEXTS = Texts.of(DockTexts.class);

  private DockTexts() {}

  /** The text of a key of {@code texts/kit.dock.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
