package org.pendant.controller.external;

import java.util.Arrays;
import java.util.Optional;

/** Modbus signal kind: what the signal reads and writes (manual 18.18, 18.19). */
public enum ModbusKind {
  DIGITAL_INPUT(0, "digital input", true, false),
  DIGITAL_OUTPUT(1, "digital output", true, true),
  REGISTER_INPUT(2, "register input", false, false),
  REGISTER_OUTPUT(3, "register output", false, true),
  DIGITAL_OUTPUTS(15, "multiple digital output", true, true),
  REGISTER_OUTPUTS(16, "multiple register output", false, true),
  /** Reads registers and writes other ones in the same request. */
  READ_WRITE_REGISTERS(23, "read-write register", false, true);

  private final int number;
  private final String words;
  private final boolean digital;
  private final boolean output;

  ModbusKind(int number, String words, boolean digital, boolean output) {
    this.number = number;
    this.words = words;
    this.digital = digital;
    this.output = output;
  }

  /** The kind that scripts call by {@code number}. */
  public static Optional<ModbusKind> of(int number) {
    return Arrays.stream(values()).filter(each -> each.number == number).findAny();
  }

  /** What scripts call it. */
  public int number() {
    return number;
  }

  /** What people call it. */
  public String words() {
    return words;
  }

  /** Whether its values are bits, 0 or 1; otherwise they are registers, 0 to 65535. */
  public boolean digital() {
    return digital;
  }

  /** Whether programs can set it. */
  public boolean output() {
    return output;
  }

  /** Whether it is read where it is written, so that what was written is its value. */
  public boolean readWhereWritten() {
    return output && this != READ_WRITE_REGISTERS;
  }
}
