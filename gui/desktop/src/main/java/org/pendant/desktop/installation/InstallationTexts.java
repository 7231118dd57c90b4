package org.pendant.desktop.installation;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class InstallationTexts {
  private static final Texts TEXTS = Texts.of(InstallationTexts.class, Messages::shown);

  private InstallationTexts() {}

  /** The text of a key of {@code texts/desktop.installation.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
