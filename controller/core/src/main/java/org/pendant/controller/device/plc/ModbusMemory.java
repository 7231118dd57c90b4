package org.pendant.controller.device.plc;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
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
  private final int first;
  private final Map<ModbusTable, int[]> tables = new EnumMap<>(ModbusTable.class);
  private List<SignalGroupState> state = List.of();
  private boolean changed = true;

  /**
   * A memory that is all zero.
   *
   * @param first address of the first value of each table, from 0
   * @param counts how many values each table has
   */
  public ModbusMemory(int first, Map<ModbusTable, Integer> counts) {
    this.first = first;
    for (ModbusTable table : ModbusTable.values()) {
      tables.put(table, new int[counts.getOrDefault(table, 0)]);
    }
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
    return count > 0 && address >= first && address + count <= first + tables.get(table).length;
  }

  /** One value of a table that holds its address. */
  int get(ModbusTable table, int address) {
    return tables.get(table)[address - first];
  }

  /** Values of a table that holds their addresses. */
  List<Integer> get(ModbusTable table, int address, int count) {
    return IntStream.range(address, address + count).mapToObj(each -> get(table, each)).toList();
  }

  /** Sets a value of a table that holds its address. */
  void set(ModbusTable table, int address, int value) {
    int[] values = tables.get(table);
    if (values[address - first] != value) {
      values[address - first] = value;
      changed = true;
    }
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
    ModbusTable table = ModbusTable.named(group);
    return new SignalLine() {
      @Override
      public int value() {
        return get(table, address);
      }

      @Override
      public void set(int value) {
        ModbusMemory.this.set(table, address, value);
      }
    };
  }

  /** All values; the same list until one changes. */
  public List<SignalGroupState> state() {
    if (changed) {
      changed = false;
      List<SignalGroupState> now = new ArrayList<>();
      tables.forEach(
          (table, values) -> {
            if (values.length > 0) {
              now.add(
                  new SignalGroupState(
                      table.text(),
                      first,
                      table.range().equals(SignalGroup.LEVEL),
                      true,
                      Arrays.stream(values).boxed().toList()));
            }
          });
      state = List.copyOf(now);
    }
    return state;
  }
}
