package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.models.json.JsonException;

/** Ports of devices: each has its own. */
final class DevicePorts {
  /** What else is at ports of the controller that a device may be given. */
  private static final List<Integer> TAKEN =
      List.of(
          29_999, 30_001, 30_002, 30_003, 30_004, 30_011, 30_012, 30_013, 30_020, 40_000, 41_414,
          44_818, 54_321, 63_352);

  private final Map<Integer, String> owners = new HashMap<>();

  /** The port in a field, which is this device's from now on. */
  int take(String name, FieldReader fields, String key) throws JsonException {
    int port = (int) fields.number(key);
    String owner = TAKEN.contains(port) ? "" : owners.putIfAbsent(port, name);
    if (owner != null) {
      String why =
          owner.isEmpty()
              ? text("portOfController", key, port)
              : owner.equals(name)
                  ? text("portOfOther", key, port)
                  : text("portTaken", key, port, owner);
      throw (fields.has(key) ? fields.all().required(key).place() : fields.all().place())
          .refusal(why);
    }
    return port;
  }

  /** Whether the controller itself is at a port of its own address. */
  static boolean isTaken(int port) {
    return TAKEN.contains(port) || port == ModbusAddress.STANDARD_PORT;
  }
}
