package org.pendant.protocols.toolserial;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ToolSerialTexts {
  private static final Texts TEXTS = Texts.english(ToolSerialTexts.class);

  private ToolSerialTexts() {}

  /** The text of a key of {@code texts/protocols.toolserial.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
