package org.pendant.desktop.session;

import org.pendant.kit.text.Messages;
import org.pendant.text.Texts;

/** What this package says to people. */
final class SessionTexts {
  private static final Texts TEXTS = Texts.of(SessionTexts.class, Messages::shown);

  private SessionTexts() {}

  /** The text of a key of {@code texts/desktop.session.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
