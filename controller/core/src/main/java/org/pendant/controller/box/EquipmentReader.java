package org.pendant.controller.box;

import java.io.InputStream;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.pendant.controller.device.DeviceReader;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.rule.RuleReader;
import org.pendant.controller.wire.CellSignalNames;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.JsonFile;

/**
 * Equipment reader: reads devices and rules from the file of a scene; docs/devices.md describes
 * them. What else is in the file is read elsewhere.
 */
public final class EquipmentReader {
  private EquipmentReader() {}

  /**
   * Reads all of {@code in}, which the caller closes.
   *
   * @param fileName for messages
   * @throws JsonException for the first thing that is wrong, with its place; also if the file
   *     cannot be read or is too large
   */
  public static CellEquipment read(String fileName, InputStream in) throws JsonException {
    JsonFields scene = new JsonFields(JsonFile.read(fileName, in), "a scene");
    CellSignalNames signals = new CellSignalNames(SignalBank.groups());
    List<DeviceSetup> devices = DeviceReader.read(scene, signals);
    Map<String, Double> grippers = new TreeMap<>();
    for (DeviceSetup device : devices) {
      if (device.holdsParts()) {
        grippers.put(device.name(), device.strokeM());
      }
    }
    List<String> switches =
        devices.stream().filter(DeviceSetup::canBePressed).map(DeviceSetup::name).toList();
    return new CellEquipment(devices, RuleReader.read(scene, signals, grippers, switches));
  }
}
