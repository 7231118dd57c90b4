package org.pendant.controller.wire;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.io.SignalBank;
import org.pendant.models.json.Range;

class CellSignalNamesTest {
  private static final Range WORD = new Range(0, 65_535, "");

  private static CellSignalNames names() {
    CellSignalNames names = new CellSignalNames(SignalBank.groups());
    names.add(
        "plc",
        List.of(
            new SignalGroup("coil", 100, 8, true, SignalGroup.LEVEL),
            new SignalGroup("register", 0, 4, true, WORD)));
    names.add("left", SignalBank.groups());
    return names;
  }

  @ParameterizedTest
  @CsvSource({
    "digital_out[7], '', digital_out, 7",
    "flag[31], '', flag, 31",
    "plc.coil[100], plc, coil, 100",
    "plc.register[3], plc, register, 3",
    "left.digital_in[0], left, digital_in, 0",
  })
  void signalHasAnOwnerGroupAndNumber(String text, String owner, String group, int index) {
    CellSignal signal = names().signal(text);

    assertEquals(new CellSignal(owner, group, index), signal);
    assertEquals(text, signal.toString());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "digital_out[8] | must be digital_out[0] to [7]",
        "plc.coil[99] | must be plc.coil[100] to [107]",
        "plc.valve[0] | must be one of plc.coil[100] to [107], plc.register[0] to [3]",
        "right.digital_out[0] | must be a signal, such as digital_out[0] or plc.coil[100] or"
            + " left.digital_in[0]",
        "coil | must be a signal, such as digital_out[0] or plc.coil[100] or left.digital_in[0]",
      })
  void whatIsNoSignalIsToldWhatThereIs(String text, String message) {
    CellSignalNames names = names();

    assertEquals(
        message,
        assertThrows(IllegalArgumentException.class, () -> names.signal(text)).getMessage());
  }

  @ParameterizedTest
  @ValueSource(strings = {"the plc", "plc.1", "1st", "", "a and b"})
  void ownerIsOneWord(String name) {
    CellSignalNames names = names();

    assertTrue(
        assertThrows(IllegalArgumentException.class, () -> names.add(name, SignalBank.groups()))
            .getMessage()
            .contains("must have letters, digits, _ and - alone"));
  }

  @Test
  void numbersAreNoDigitalSignals() {
    assertTrue(names().group(names().signal("plc.coil[100]")).digital());
    assertEquals(WORD, names().group(names().signal("plc.register[0]")).range());
  }
}
