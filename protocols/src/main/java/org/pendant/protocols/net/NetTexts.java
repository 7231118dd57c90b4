package org.pendant.protocols.net;

import org.pendant.text.Texts;

/** What this package says to people. */
final class NetTexts {
  private static final Texts TEXTS = Texts.english(NetTexts.class);

  private NetTexts() {}

  /** The text of a key of {@code texts/protocols.net.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
