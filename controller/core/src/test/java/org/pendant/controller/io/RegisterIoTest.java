package org.pendant.controller.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class RegisterIoTest {
  private final RegisterIo io = new RegisterIo();

  @Test
  void everyRegisterIsSetAlone() {
    for (int i = 0; i < RegisterKind.BOOLEAN.size(); i++) {
      io.setBool(i, true);
      assertEquals(i < 64 ? 1L << i : 0, io.levels().lowBits());
      assertEquals(i < 64 ? 0 : 1L << (i - 64), io.levels().highBits());
      assertTrue(io.levels().bool(i));
      io.setBool(i, false);
      assertFalse(io.bool(i));
    }
    for (int i = 0; i < RegisterKind.INTEGER.size(); i++) {
      io.setInteger(i, i - 20);
      io.setFloating(i, i / 4.0);
    }
    for (int i = 0; i < RegisterKind.INTEGER.size(); i++) {
      assertEquals(i - 20, io.levels().integer(i));
      assertEquals(i / 4.0, io.levels().floating(i));
    }
  }

  @Test
  void aSnapshotKeepsItsValues() {
    io.setInteger(5, 1);
    io.setFloating(5, 1);
    io.setBool(5, true);
    RegisterLevels before = io.levels();
    io.setInteger(5, 2);
    io.setFloating(5, 2);
    io.setBool(5, false);
    assertEquals(1, before.integer(5));
    assertEquals(1, before.floating(5));
    assertTrue(before.bool(5));
    assertNotEquals(before, io.levels());
  }

  @Test
  void theSnapshotStaysTheSameObjectWhileNothingChanges() {
    assertSame(RegisterLevels.ZERO, io.levels());
    io.setFloating(0, 1.5);
    RegisterLevels levels = io.levels();
    io.setFloating(0, 1.5);
    io.setInteger(0, 0);
    io.setBool(0, false);
    assertSame(levels, io.levels());
  }

  @Test
  void addressesBeyondAKindAreRefused() {
    String message =
        assertThrows(IllegalArgumentException.class, () -> io.setBool(128, true)).getMessage();
    assertEquals("boolean register: address is 128, must be 0 to 127", message);
    assertThrows(IllegalArgumentException.class, () -> io.setInteger(48, 1));
    assertThrows(IllegalArgumentException.class, () -> io.floating(-1));
    RegisterLevels levels = io.levels();
    assertThrows(IllegalArgumentException.class, () -> levels.integer(48));
    assertThrows(IllegalArgumentException.class, () -> levels.floating(48));
    assertThrows(IllegalArgumentException.class, () -> levels.bool(-1));
  }
}
