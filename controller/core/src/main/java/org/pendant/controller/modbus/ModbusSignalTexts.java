package org.pendant.controller.modbus;

import org.pendant.text.Texts;

/** What this package says to people. */
final class ModbusSignalTexts {
  private static final Texts TEXTS = Texts.english(ModbusSignalTexts.class);

  private ModbusSignalTexts() {}

  /** The text of a key of {@code texts/controller.modbus.properties}, filled with values. */
  static String text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
