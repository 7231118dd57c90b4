package org.pendant.controller.bench;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.bench.ModbusDevice.Table;

/**
 * Modbus command: what a request that a program has made of bytes writes.
 *
 * @param address of the first value
 */
record ModbusCommand(Table table, int address, List<Integer> values) {
  private static final int WRITE_COIL = 5;
  private static final int WRITE_REGISTER = 6;
  private static final int WRITE_COILS = 15;
  private static final int WRITE_REGISTERS = 16;

  private static final int WORD = 0xFFFF;

  /** Address and value, or address, count, and number of bytes. */
  private static final int SINGLE_BYTES = 4;

  private static final int HEAD_BYTES = 5;

  /** What a request writes; empty where it does something else, or is not as it must be. */
  static Optional<ModbusCommand> of(int function, byte[] data) {
    ByteBuffer bytes = ByteBuffer.wrap(data);
    return switch (function) {
      case WRITE_COIL, WRITE_REGISTER ->
          data.length == SINGLE_BYTES
              ? Optional.of(single(function == WRITE_COIL, bytes))
              : Optional.empty();
      case WRITE_COILS, WRITE_REGISTERS ->
          data.length > HEAD_BYTES ? several(function == WRITE_COILS, bytes) : Optional.empty();
      default -> Optional.empty();
    };
  }

  private static ModbusCommand single(boolean coil, ByteBuffer bytes) {
    int address = bytes.getShort() & WORD;
    int value = bytes.getShort() & WORD;
    return coil
        ? new ModbusCommand(Table.COILS, address, List.of(value == 0 ? 0 : 1))
        : new ModbusCommand(Table.REGISTERS, address, List.of(value));
  }

  private static Optional<ModbusCommand> several(boolean coils, ByteBuffer bytes) {
    int address = bytes.getShort() & WORD;
    int count = bytes.getShort() & WORD;
    int length = bytes.get() & 0xFF;
    int needed = coils ? (count + Byte.SIZE - 1) / Byte.SIZE : count * Short.BYTES;
    if (length != needed || bytes.remaining() != needed) {
      return Optional.empty();
    }
    List<Integer> values = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      values.add(
          coils
              ? bytes.get(HEAD_BYTES + i / Byte.SIZE) >> i % Byte.SIZE & 1
              : bytes.getShort() & WORD);
    }
    return Optional.of(new ModbusCommand(coils ? Table.COILS : Table.REGISTERS, address, values));
  }

  void into(ModbusDevice device) {
    device.set(table, address, values);
  }
}
