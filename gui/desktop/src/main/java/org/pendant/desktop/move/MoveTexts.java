package org.pendant.desktop.move;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class MoveTexts {
  private static final Texts TEXTS = Texts.of(MoveTexts.class, Messages::shown);

  private MoveTexts() {}

  /** The text of a key of {@code texts/desktop.move.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
