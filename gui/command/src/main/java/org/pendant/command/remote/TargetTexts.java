package org.pendant.command.remote;

import org.pendant.text.Texts;

/** What this package says to people. */
final class TargetTexts {
  private static final Texts TEXTS = Texts.english(TargetTexts.class);

  private TargetTexts() {}

  /** The text of a key of {@code texts/command.remote.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
