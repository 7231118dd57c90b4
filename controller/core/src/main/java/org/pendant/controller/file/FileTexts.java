package org.pendant.controller.file;

import org.pendant.text.Texts;

/** What this package says to people. */
final class FileTexts {
  private static final Texts TEXTS = Texts.english(FileTexts.class);

  private FileTexts() {}

  /** The text of a key of {@code texts/controller.file.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
