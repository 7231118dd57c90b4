package org.pendant.sweep.folder;

import org.pendant.text.Texts;

/** What this package says to people. */
final class FolderTexts {
  private static final Texts TEXTS = Texts.english(FolderTexts.class);

  private FolderTexts() {}

  /** The text of a key of {@code texts/sweep.folder.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
