package org.pendant.script.vm;

import static org.pendant.script.vm.MachineTexts.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.pendant.script.value.ListValue;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;

/** Static slots: gives constants and global variables theirs while a program is compiled. */
final class StaticSlots {
  private final int first;
  private final int last;
  private final Map<String, Integer> globals;
  private final Map<Value, Integer> constants = new HashMap<>();
  private final List<String> names = new ArrayList<>();
  private final List<Value> values = new ArrayList<>();

  StaticSlots() {
    this(0, Instruction.MAX_OPERAND, new HashMap<>());
  }

  /** Slots {@code first} to {@code last} for statements linked into a program. */
  StaticSlots(int first, int last, Map<String, Integer> globals) {
    this.first = first;
    this.last = last;
    this.globals = globals;
  }

  /** The same slots, to which others can be added on the side. */
  StaticSlots copy() {
    StaticSlots copy = new StaticSlots(first, last, new HashMap<>(globals));
    copy.constants.putAll(constants);
    copy.names.addAll(names);
    copy.values.addAll(values);
    return copy;
  }

  int first() {
    return first;
  }

  int global(String name) {
    Integer known = globals.get(name);
    return known != null ? known : enter(name);
  }

  private int enter(String name) {
    int slot = add(name, NoneValue.NONE);
    globals.put(name, slot);
    return slot;
  }

  /** The slot of a constant; equal ones share it unless a program could change them. */
  int constant(Value value) {
    if (value instanceof ListValue
        || value instanceof MatrixValue
        || value instanceof StructValue) {
      return add("", value);
    }
    Integer known = constants.get(value);
    if (known == null) {
      known = add("", value);
      constants.put(value, known);
    }
    return known;
  }

  private int add(String name, Value value) {
    int slot = first + names.size();
    if (slot > last) {
      throw new ProgramTooLarge(text("tooManyGlobals", last - first + 1));
    }
    names.add(name);
    values.add(value);
    return slot;
  }

  List<String> names() {
    return names;
  }

  List<Value> values() {
    return values;
  }
}
