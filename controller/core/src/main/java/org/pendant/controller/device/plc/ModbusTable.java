package org.pendant.controller.device.plc;

import org.pendant.controller.external.ModbusKind;
import org.pendant.controller.wire.SignalGroup;
import org.pendant.models.json.Range;

/** Modbus table: one of the four kinds of values that a device has (Modbus V1.1b3, 4.3). */
public enum ModbusTable {
  COIL("coil", SignalGroup.LEVEL),
  INPUT("input", SignalGroup.LEVEL),
  REGISTER("register", new Range(0, 0xFFFF, "")),
  INPUT_REGISTER("input_register", new Range(0, 0xFFFF, ""));

  private final String text;
  private final Range range;

  ModbusTable(String text, Range range) {
    this.text = text;
    this.range = range;
  }

  /** The name of its signals, as in {@code coil[0]}. */
  public String text() {
    return text;
  }

  /** What its values may be. */
  Range range() {
    return range;
  }

  /** The table that a signal of a controller reads. */
  static ModbusTable of(ModbusKind kind) {
    return switch (kind) {
      case DIGITAL_INPUT -> INPUT;
      case DIGITAL_OUTPUT, DIGITAL_OUTPUTS -> COIL;
      case REGISTER_INPUT -> INPUT_REGISTER;
      case REGISTER_OUTPUT, REGISTER_OUTPUTS, READ_WRITE_REGISTERS -> REGISTER;
    };
  }
}
