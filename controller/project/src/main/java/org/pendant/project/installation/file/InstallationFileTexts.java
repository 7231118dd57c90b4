package org.pendant.project.installation.file;

import org.pendant.text.Texts;

/** What this package says to people. */
final class InstallationFileTexts {
  private static final Texts TEXTS = Texts.english(InstallationFileTexts.class);

  private InstallationFileTexts() {}

  /**
   * The text of a key of {@code texts/project.installation.file.properties}, filled with values.
   */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
