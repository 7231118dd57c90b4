package org.pendant.desktop.io;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.RegisterKind;

class MemoryTest {
  private static String described(RegisterDirection direction, RegisterKind kind) {
    Memory memory = new Memory.Registers(direction, kind);
    return memory.title() + ", " + memory.id();
  }

  @Test
  void registersAreCalledByKindAndDirection() {
    assertEquals(
        "Boolean input registers, boolean-input-registers",
        described(RegisterDirection.INPUT, RegisterKind.BOOLEAN));
    assertEquals(
        "Boolean output registers, boolean-output-registers",
        described(RegisterDirection.OUTPUT, RegisterKind.BOOLEAN));
    assertEquals(
        "Integer input registers, integer-input-registers",
        described(RegisterDirection.INPUT, RegisterKind.INTEGER));
    assertEquals(
        "Integer output registers, integer-output-registers",
        described(RegisterDirection.OUTPUT, RegisterKind.INTEGER));
    assertEquals(
        "Float input registers, float-input-registers",
        described(RegisterDirection.INPUT, RegisterKind.FLOAT));
    assertEquals(
        "Float output registers, float-output-registers",
        described(RegisterDirection.OUTPUT, RegisterKind.FLOAT));
  }

  @Test
  void flagsAreCalledFlags() {
    assertEquals("Flags", new Memory.Flags().title());
    assertEquals("flags", new Memory.Flags().id());
  }
}
