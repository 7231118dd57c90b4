package org.pendant.desktop.io;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.controller.external.ModbusExchange;
import org.pendant.controller.external.ModbusKind;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.modbus.ModbusSignalState;

final class ModbusRowTest {

  private static ModbusRow row(
      ModbusKind kind, int updateHz, List<Integer> values, boolean valid, int deviceError) {
    ModbusExchange exchange =
        new ModbusExchange(
            new ModbusAddress("10.0.0.5", 502), 255, kind, 12, values.size(), 12, 1, false);
    return ModbusRow.of(
            List.of(
                new ModbusSignalState("door", exchange, updateHz, values, valid, deviceError, 0)))
        .getFirst();
  }

  @Test
  void aBitIsHighOrLow() {
    ModbusRow row = row(ModbusKind.DIGITAL_INPUT, 10, List.of(1), true, 0);
    assertEquals(
        new ModbusRow(
            "door", "digital input 12, unit 255 at 10.0.0.5:502", "high", "OK", false, "10 Hz"),
        row);
  }

  @Test
  void severalRegistersAreNumbers() {
    ModbusRow row = row(ModbusKind.REGISTER_OUTPUTS, 0, List.of(3, 65_535), true, 0);
    assertEquals("3, 65535", row.value());
    assertEquals("on demand", row.rate());
  }

  @Test
  void whatIsWrongIsToldInWords() {
    assertEquals(
        "device error 6, server busy",
        row(ModbusKind.REGISTER_INPUT, 10, List.of(0), false, 6).status());
    assertEquals(
        "No answer yet", row(ModbusKind.REGISTER_INPUT, 10, List.of(0), false, 0).status());
  }

  @Test
  void theSerialLineIsInWords() {
    assertEquals("Off", ToolCard.words(ToolCommunication.STANDARD));
    assertEquals(
        "9600 baud, even parity, 2 stop bits",
        ToolCard.words(
            new ToolCommunication(true, 9600, ToolCommunication.Parity.EVEN, 2, 1.5f, 3.5f)));
  }
}
