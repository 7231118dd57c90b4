package org.pendant.desktop.sweep;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class SweepTexts {
  private static final Texts TEXTS = Texts.of(SweepTexts.class, Messages::shown);

  private SweepTexts() {}

  /** The text of a key of {@code texts/desktop.sweep.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
