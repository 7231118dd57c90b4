package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.EnumMap;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import org.pendant.controller.device.plc.AdapterScanner;
import org.pendant.controller.device.plc.ModbusMemory;
import org.pendant.controller.device.plc.ModbusTable;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.controller.wire.CellSignal;
import org.pendant.controller.wire.CellSignalNames;
import org.pendant.controller.wire.SignalGroup;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.Range;

/** PLC reader: reads PLCs, those that are reached at addresses and scanners of the adapter. */
final class PlcReader {
  private static final String ADDRESS = "address";
  private static final String PORT = "port";
  private static final String FIRST = "first";
  private static final int MAX_ADDRESS = 65_535;

  private static final Map<ModbusTable, String> COUNTS =
      new EnumMap<>(
          Map.of(
              ModbusTable.COIL, "coils",
              ModbusTable.INPUT, "inputs",
              ModbusTable.REGISTER, "registers",
              ModbusTable.INPUT_REGISTER, "input_registers"));

  private final DevicePorts ports;
  private final Map<ModbusAddress, String> addresses = new HashMap<>();

  PlcReader(DevicePorts ports) {
    this.ports = ports;
  }

  DeviceSetup modbus(String name, FieldReader fields) throws JsonException {
    ModbusAddress address = address(name, fields);
    int first = (int) fields.number(FIRST);
    Map<ModbusTable, Integer> counts = new EnumMap<>(ModbusTable.class);
    for (Map.Entry<ModbusTable, String> each : COUNTS.entrySet()) {
      int count = (int) fields.number(each.getValue());
      if (first + count - 1 > MAX_ADDRESS) {
        throw fields
            .all()
            .required(FIRST)
            .place()
            .refusal(text("firstRange", first, MAX_ADDRESS + 1 - count, count, each.getValue()));
      }
      counts.put(each.getKey(), count);
    }
    OptionalInt port =
        fields.has(PORT) ? OptionalInt.of(ports.take(name, fields, PORT)) : OptionalInt.empty();
    return new DeviceSetup.Modbus(
        name,
        address,
        fields.whole("unit"),
        port,
        first,
        counts,
        values(fields, ModbusMemory.groups(first, counts)));
  }

  static DeviceSetup scanner(String name, FieldReader fields) throws JsonException {
    return new DeviceSetup.EthernetIp(
        name, fields.number("interval"), values(fields, AdapterScanner.WRITTEN));
  }

  private ModbusAddress address(String name, FieldReader fields) throws JsonException {
    Json.Text text = fields.words(ADDRESS);
    ModbusAddress address;
    try {
      address = ModbusAddress.parse(text.value());
    } catch (IllegalArgumentException e) {
      throw text.place().refusal(text("addressRefused", text.described(), e.getMessage()));
    }
    if (OwnAddress.isHost(address.host()) && DevicePorts.isTaken(address.port())) {
      throw text.place().refusal(text("addressOfController", text.described()));
    }
    String owner = addresses.putIfAbsent(address, name);
    if (owner != null) {
      throw text.place().refusal(text("addressTaken", text.described(), owner));
    }
    return address;
  }

  private static Map<CellSignal, Integer> values(FieldReader fields, List<SignalGroup> groups)
      throws JsonException {
    CellSignalNames signals = new CellSignalNames(groups);
    Map<CellSignal, Integer> values = new LinkedHashMap<>();
    for (Map.Entry<String, Json> each : fields.values("values").entrySet()) {
      Json value = each.getValue();
      CellSignal signal;
      try {
        signal = signals.signal(each.getKey());
      } catch (IllegalArgumentException e) {
        throw value.place().refusal(Json.quoted(each.getKey()) + ": " + e.getMessage());
      }
      Range range = signals.group(signal).range();
      double number = JsonFields.number(each.getKey(), value, range);
      if (number != Math.rint(number)) {
        throw value.place().refusal(text("mustBeWhole", each.getKey(), Range.number(number)));
      }
      values.put(signal, (int) number);
    }
    return values;
  }
}
