package org.pendant.protocols.realtime;

import org.pendant.text.Texts;

/** What this package says to people. */
final class RealtimeTexts {
  private static final Texts TEXTS = Texts.english(RealtimeTexts.class);

  private RealtimeTexts() {}

  /** The text of a key of {@code texts/protocols.realtime.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
