package org.pendant.project.installation.text;

import org.pendant.text.Texts;

/** What this package says to people. */
final class InstallationLineTexts {
  private static final Texts TEXTS = Texts.english(InstallationLineTexts.class);

  private InstallationLineTexts() {}

  /**
   * The text of a key of {@code texts/project.installation.text.properties}, filled with values.
   */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
