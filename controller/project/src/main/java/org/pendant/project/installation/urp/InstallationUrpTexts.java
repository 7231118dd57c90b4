package org.pendant.project.installation.urp;

import org.pendant.text.Texts;

/** What this package says to people. */
final class InstallationUrpTexts {
  private static final Texts TEXTS = Texts.english(InstallationUrpTexts.class);

  private InstallationUrpTexts() {}

  /** The text of a key of {@code texts/project.installation.urp.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
