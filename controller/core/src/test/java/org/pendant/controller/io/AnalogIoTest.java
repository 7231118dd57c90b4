package org.pendant.controller.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

class AnalogIoTest {
  private static final double TOLERANCE = 1e-12;

  private final AnalogIo io = new AnalogIo();

  @Test
  void aNewBoxMeasuresVoltsAndPutsOutTheLowestCurrent() {
    AnalogSignal input = new AnalogSignal(0, AnalogDomain.VOLTAGE);
    AnalogSignal output = new AnalogSignal(0.004, AnalogDomain.CURRENT);
    assertEquals(new AnalogLevels(input, input, output, output, input, input), io.levels());
    assertEquals(0b0011, io.levels().standardDomainBits());
    assertEquals(0b11, io.levels().toolDomainBits());
  }

  @Test
  void anInputReadsWhatIsConnectedInItsDomain() {
    io.setInput(AnalogBank.TOOL_IN, 1, 7.5, AnalogDomain.VOLTAGE);
    io.setInput(AnalogBank.TOOL_IN, 1, 0.011, AnalogDomain.CURRENT);
    assertEquals(7.5, io.value(AnalogBank.TOOL_IN, 1));
    io.setDomain(AnalogBank.TOOL_IN, 1, AnalogDomain.CURRENT);
    assertEquals(0.011, io.value(AnalogBank.TOOL_IN, 1));
    assertEquals(0, io.value(AnalogBank.TOOL_IN, 0));
    assertEquals(
        new AnalogSignal(0.011, AnalogDomain.CURRENT), io.levels().signal(AnalogBank.TOOL_IN, 1));
  }

  @Test
  void anOutputKeepsItsPartOfTheRangeInEitherDomain() {
    io.setOutput(0, 0.25);
    assertEquals(0.008, io.value(AnalogBank.STANDARD_OUT, 0), TOLERANCE);
    io.setDomain(AnalogBank.STANDARD_OUT, 0, AnalogDomain.VOLTAGE);
    assertEquals(2.5, io.value(AnalogBank.STANDARD_OUT, 0), TOLERANCE);
    assertEquals(0.25, io.levels().standardOut0().ratio(), TOLERANCE);
  }

  @Test
  void theSnapshotStaysTheSameObjectWhileNothingToBeReadChanges() {
    AnalogLevels levels = io.levels();
    io.setInput(AnalogBank.STANDARD_IN, 0, 0.02, AnalogDomain.CURRENT);
    io.setDomain(AnalogBank.STANDARD_IN, 0, AnalogDomain.VOLTAGE);
    io.setOutput(1, 0);
    assertSame(levels, io.levels());
    io.setInput(AnalogBank.STANDARD_IN, 0, 1, AnalogDomain.VOLTAGE);
    assertEquals(1, io.levels().standardIn0().value());
  }

  @Test
  void signalsBeyondABankAreRefused() {
    assertThrows(IllegalArgumentException.class, () -> io.value(AnalogBank.STANDARD_IN, 2));
    assertThrows(IllegalArgumentException.class, () -> io.setOutput(-1, 0));
    AnalogLevels levels = io.levels();
    assertThrows(IllegalArgumentException.class, () -> levels.signal(AnalogBank.TOOL_IN, 2));
  }
}
