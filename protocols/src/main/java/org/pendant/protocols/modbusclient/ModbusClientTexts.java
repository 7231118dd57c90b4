package org.pendant.protocols.modbusclient;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ModbusClientTexts {
  private static final Texts TEXTS = Texts.english(ModbusClientTexts.class);

  private ModbusClientTexts() {}

  /** The text of a key of {@code texts/protocols.modbusclient.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
