package org.pendant.controller.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

final class DigitalIoTest {
  private final DigitalIo io = new DigitalIo();

  @Test
  void everySignalIsLowAtFirstAndSetAlone() {
    for (SignalBank bank : SignalBank.values()) {
      for (int i = 0; i < bank.size(); i++) {
        assertFalse(io.level(bank, i));
        io.set(bank, i, true);
        assertTrue(io.levels().level(new Signal(bank, i)));
        assertEquals(1 << i, io.levels().bits(bank));
        io.set(bank, i, false);
        assertEquals(DigitalLevels.ALL_LOW, io.levels());
      }
    }
  }

  @Test
  void inputsAreSetByTheirNames() {
    io.setInput("digital_in[0]", true);
    io.setInput("configurable_in[3]", true);
    io.setInput("tool_in[1]", true);
    assertEquals(new DigitalLevels(1, 0, 8, 0, 2, 0, 0), io.levels());
  }

  @Test
  void anUnknownInputIsRefusedWithTheNamesThereAre() {
    for (String name : new String[] {"digital_in[8]", "digital_out[0]", "digital_in", "x[0]", ""}) {
      String message =
          assertThrows(IllegalArgumentException.class, () -> io.setInput(name, true)).getMessage();
      assertEquals(
          "input is '"
              + name
              + "', must be one of digital_in[0] to [7], configurable_in[0] to [7],"
              + " tool_in[0] to [1]",
          message);
    }
  }

  @Test
  void signalsBeyondABankAreRefused() {
    assertThrows(IllegalArgumentException.class, () -> io.level(SignalBank.TOOL_IN, 2));
    assertThrows(IllegalArgumentException.class, () -> io.set(SignalBank.FLAG, -1, true));
  }

  @Test
  void theSnapshotStaysTheSameObjectWhileNothingChanges() {
    io.set(SignalBank.FLAG, 31, true);
    DigitalLevels levels = io.levels();
    io.set(SignalBank.FLAG, 31, true);
    assertSame(levels, io.levels());
  }
}
