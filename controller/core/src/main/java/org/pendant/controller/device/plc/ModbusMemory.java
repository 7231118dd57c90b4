package org.pendant.controller.device.plc;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.pendant.controller.wire.SignalGroup;
import org.pendant.controller.wire.SignalGroupState;
import org.pendant.controller.wire.SignalLine;

/**
 * Modbus memory of a device: its coils, inputs, registers and input registers. A table has its
 * values at the addresses from {@code first} on. The frame loop owns it.
 */
public final class ModbusMemory {
  private final SignalMemory memory;

  /**
   * A memory that is all zero.
   *
   * @param first address of the first value of each table, from 0
   * @param counts how many values each table has
   */
  public ModbusMemory(int first, Map<ModbusTable, Integer> counts) {
    memory = new SignalMemory(groups(first, counts));
  }

  /** Its tables as signals; those without a value are left out. */
  public static List<SignalGroup> groups(int first, Map<ModbusTable, Integer> counts) {
    return Arrays.stream(ModbusTable.values())
        .filter(table -> counts.getOrDefault(table, 0) > 0)
        .map(table -> new SignalGroup(table.text(), first, counts.get(table), true, table.range()))
        .toList();
  }

  /** Whether a table has all of these addresses. */
  boolean holds(ModbusTable table, int address, int count) {
    return memory.holds(table.text(), address, count);
  }

  /** One value of a table that holds its address. */
  int get(ModbusTable table, int address) {
    return memory.get(table.text(), address);
  }

  /** Values of a table that holds their addresses. */
  List<Integer> get(ModbusTable table, int address, int count) {
    return IntStream.range(address, address + count).mapToObj(each -> get(table, each)).toList();
  }

  /** Sets a value of a table that holds its address. */
  void set(ModbusTable table, int address, int value) {
    memory.set(table.text(), address, value);
  }

  /** Sets values of a table that holds their addresses. */
  void set(ModbusTable table, int address, List<Integer> values) {
    for (int i = 0; i < values.size(); i++) {
      set(table, address + i, values.get(i));
    }
  }

  /**
   * A value as a signal.
   *
   * @param group the name of a table
   */
  public SignalLine line(String group, int address) {
    return memory.line(group, address);
  }

  /** All values; the same list until one changes. */
  public List<SignalGroupState> state() {
    return memory.state();
  }
}
