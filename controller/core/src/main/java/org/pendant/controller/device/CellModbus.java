package org.pendant.controller.device;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.device.plc.ModbusUnit;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.controller.external.ModbusConnector;
import org.pendant.controller.external.ModbusErrors;
import org.pendant.controller.external.ModbusExchange;
import org.pendant.controller.external.ModbusPoint;
import org.pendant.controller.external.Pending;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;

/** Cell Modbus: the way to Modbus devices, those of the cell before all others. */
record CellModbus(List<CellDevice> devices, ModbusConnector others) implements ModbusConnector {
  @Override
  public ModbusPoint add(ModbusExchange exchange) throws ScriptError {
    Optional<ModbusUnit> unit = unit(exchange.device());
    return unit.isPresent() ? unit.get().add(exchange) : others.add(exchange);
  }

  @Override
  public Pending send(ModbusAddress device, int unit, int function, byte[] data)
      throws ScriptError {
    Optional<ModbusUnit> there = unit(device);
    if (there.isEmpty()) {
      return others.send(device, unit, function, data);
    }
    String request = (char) function + new String(data, StandardCharsets.ISO_8859_1);
    if (there.get().answer(unit, request).isEmpty()) {
      throw new ScriptError(
          "modbus-unreached", device + ": " + ModbusErrors.connection(ModbusErrors.NO_ANSWER));
    }
    return new AnsweredNow(NoneValue.NONE);
  }

  private Optional<ModbusUnit> unit(ModbusAddress address) {
    return devices.stream()
        .filter(PlcDevice.class::isInstance)
        .map(PlcDevice.class::cast)
        .flatMap(each -> each.unit(address).stream())
        .findFirst();
  }
}
