package org.pendant.controller.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class PortMapTest {
  private final Signals signals = new Signals();

  private Optional<Integer> register(int address) {
    return PortMap.register(address, signals.digital().levels(), signals.state());
  }

  private Optional<Boolean> bit(int address) {
    return PortMap.bit(address, signals.digital().levels(), signals.state());
  }

  private void writeRegister(int address, int value) {
    PortMap.writeRegister(address, value).orElseThrow().forEach(signals::write);
  }

  @Test
  void inputsAreReadInBitsAndRegisters() {
    signals.digital().set(SignalBank.STANDARD_IN, 3, true);
    signals.digital().set(SignalBank.TOOL_IN, 1, true);
    signals.digital().set(SignalBank.CONFIGURABLE_IN, 7, true);
    assertEquals(Optional.of(0x208), register(0));
    assertEquals(Optional.of(2), register(21));
    assertEquals(Optional.of(0x80), register(30));
    for (int i = 0; i < 48; i++) {
      assertEquals(Optional.of(i == 3 || i == 9 || i == 39), bit(i), "bit " + i);
    }
  }

  @Test
  void analogInputsAreReadAsPartsOfTheirRange() {
    signals.write(new SignalWrite.AnalogInput(AnalogBank.STANDARD_IN, 1, 10, AnalogDomain.VOLTAGE));
    signals.write(new SignalWrite.Domain(AnalogBank.TOOL_IN, 0, AnalogDomain.CURRENT));
    signals.write(new SignalWrite.AnalogInput(AnalogBank.TOOL_IN, 0, 0.012, AnalogDomain.CURRENT));
    assertEquals(
        List.of(0, 1, 65535, 1, 32768, 0, 0, 1),
        List.of(4, 5, 6, 7, 8, 9, 10, 11).stream().map(a -> register(a).orElseThrow()).toList());
  }

  @Test
  void whatIsWrittenIsReadAgain() {
    for (int address : List.of(5, 7, 9, 11, 16, 17, 18, 19, 22, 31, 128, 255)) {
      writeRegister(address, 1);
      assertEquals(Optional.of(1), register(address), "register " + address);
      writeRegister(address, 0);
      assertEquals(Optional.of(0), register(address), "register " + address);
    }
    writeRegister(1, 0x3FF);
    assertEquals(Optional.of(0x3FF), register(1));
    writeRegister(20, 12);
    assertEquals(Optional.of(12), register(20));
    writeRegister(200, 0xFFFF);
    assertEquals(Optional.of(0xFFFF), register(200));
    assertEquals((short) -1, signals.state().ports().register(200));
  }

  @Test
  void whatOnlyReadsTakesNoWrites() {
    for (int address : List.of(0, 4, 6, 8, 10, 21, 30)) {
      assertEquals(Optional.of(List.of()), PortMap.writeRegister(address, 1));
    }
    assertEquals(Optional.of(List.of()), PortMap.writeBit(9, true));
    assertEquals(Optional.of(List.of()), PortMap.writeBit(39, true));
  }

  @Test
  void thereAreGaps() {
    for (int address : List.of(-1, 12, 15, 23, 34, 127, 256, 100_000)) {
      assertEquals(Optional.empty(), register(address));
      assertEquals(Optional.empty(), PortMap.writeRegister(address, 0));
    }
    for (int address : List.of(-1, 48, 127, 256)) {
      assertEquals(Optional.empty(), bit(address));
      assertEquals(Optional.empty(), PortMap.writeBit(address, true));
    }
  }

  @Test
  void aValueThatTheSignalDoesNotTakeIsRefused() {
    assertThrows(IllegalArgumentException.class, () -> PortMap.writeRegister(20, 13));
    assertThrows(IllegalArgumentException.class, () -> PortMap.writeRegister(5, 2));
  }

  @Test
  void everyBitOfTheMemoryIsSetAlone() {
    for (int i = 128; i < 256; i++) {
      PortMap.writeBit(i, true).orElseThrow().forEach(signals::write);
      for (int other = 128; other < 256; other++) {
        assertEquals(Optional.of(other == i), bit(other));
      }
      PortMap.writeBit(i, false).orElseThrow().forEach(signals::write);
    }
    assertEquals(PortLevels.ZERO, signals.state().ports());
  }
}
