package org.pendant.sweep.remote;

import org.pendant.text.Texts;

/** What this package says to people. */
final class RemoteTexts {
  private static final Texts TEXTS = Texts.english(RemoteTexts.class);

  private RemoteTexts() {}

  /** The text of a key of {@code texts/sweep.remote.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
