package org.pendant.controller.external;

import java.util.Arrays;
import java.util.Optional;

/** Modbus signal kind: what the signal reads and writes (manual 18.18, 18.19). */
public enum ModbusKind {
  DIGITAL_INPUT(0, "digitalInput", true, false),
  DIGITAL_OUTPUT(1, "digitalOutput", true, true),
  REGISTER_INPUT(2, "registerInput", false, false),
  REGISTER_OUTPUT(3, "registerOutput", false, true),
  DIGITAL_OUTPUTS(15, "multipleDigitalOutput", true, true),
  REGISTER_OUTPUTS(16, "multipleRegisterOutput", false, true),
  /** Reads registers and writes other ones in the same request. */
  READ_WRITE_REGISTERS(23, "readWriteRegister", false, true);

  private final int number;
  private final String key;
  private final boolean digital;
  private final boolean output;

  ModbusKind(int number, String key, boolean digital, boolean output) {
    this.number = number;
    this.key = key;
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
    return ExternalTexts.text(key);
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
