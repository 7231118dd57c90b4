package org.pendant.controller.rtde;

import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.RegisterKind;

/** The general-purpose registers of both directions. */
final class RegisterFields {
  /** The first boolean register with a field of its own; those below come by 32. */
  private static final int FIRST_SINGLE = 64;

  private RegisterFields() {}

  static void addTo(FieldList list) {
    add(list, RegisterDirection.OUTPUT);
    add(list, RegisterDirection.INPUT);
  }

  private static void add(FieldList list, RegisterDirection direction) {
    String side = direction.text();
    list.uint32(
        side + "_bit_registers0_to_31",
        state -> (int) state.signals().registers(direction).lowBits());
    list.uint32(
        side + "_bit_registers32_to_63",
        state -> (int) (state.signals().registers(direction).lowBits() >>> Integer.SIZE));
    for (int i = FIRST_SINGLE; i < RegisterKind.BOOLEAN.size(); i++) {
      int address = i;
      list.bool(
          side + "_bit_register_" + i, state -> state.signals().registers(direction).bool(address));
    }
    for (int i = 0; i < RegisterKind.INTEGER.size(); i++) {
      int address = i;
      list.int32(
          side + "_int_register_" + i,
          state -> state.signals().registers(direction).integer(address));
    }
    for (int i = 0; i < RegisterKind.FLOAT.size(); i++) {
      int address = i;
      list.number(
          side + "_double_register_" + i,
          state -> state.signals().registers(direction).floating(address));
    }
  }
}
