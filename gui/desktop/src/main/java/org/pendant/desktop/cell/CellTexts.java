package org.pendant.desktop.cell;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class CellTexts {
  private static final Texts TEXTS = Texts.of(CellTexts.class, Messages::shown);

  private CellTexts() {}

  /** The text of a key of {@code texts/desktop.cell.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
