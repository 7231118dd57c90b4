package org.pendant.sweep.table;

import org.pendant.text.Texts;

/** What this package says to people. */
final class TableTexts {
  private static final Texts TEXTS = Texts.english(TableTexts.class);

  private TableTexts() {}

  /** The text of a key of {@code texts/sweep.table.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
