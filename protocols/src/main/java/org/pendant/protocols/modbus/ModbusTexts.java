package org.pendant.protocols.modbus;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ModbusTexts {
  private static final Texts TEXTS = Texts.english(ModbusTexts.class);

  private ModbusTexts() {}

  /** The text of a key of {@code texts/protocols.modbus.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
