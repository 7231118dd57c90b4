package org.pendant.controller.box;

import static org.pendant.controller.box.BoxTexts.text;

import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.pendant.controller.device.DeviceReader;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.device.OwnedDevice;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.layout.CellLayout;
import org.pendant.controller.layout.LayoutReader;
import org.pendant.controller.rule.RuleReader;
import org.pendant.controller.wire.CellSignalNames;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.JsonFile;

/**
 * Equipment reader: reads devices, rules and wires from the file of a scene; docs/devices.md and
 * docs/cells.md describe them. What else is in the file is read elsewhere.
 */
public final class EquipmentReader {
  private EquipmentReader() {}

  /**
   * Reads all of {@code in}, which the caller closes: what there is for one controller, that of the
   * first arm where the cell has several.
   *
   * @param fileName for messages
   * @throws JsonException for the first thing that is wrong, with its place; also if the file
   *     cannot be read or is too large
   */
  public static CellEquipment read(String fileName, InputStream in) throws JsonException {
    JsonFields scene = new JsonFields(JsonFile.read(fileName, in), "a scene");
    return plan(scene, LayoutReader.readWithoutTools(scene)).ofFirst();
  }

  /**
   * What there is for each of the controllers.
   *
   * @throws JsonException for the first thing that is wrong, with its place
   */
  static EquipmentPlan plan(JsonFields scene, CellLayout layout) throws JsonException {
    List<String> controllers = layout.names();
    CellSignalNames signals = new CellSignalNames(SignalBank.groups());
    controllers.forEach(each -> signals.add(each, SignalBank.groups()));
    List<OwnedDevice> devices = DeviceReader.read(scene, signals, controllers);
    Map<String, Double> grippers = new TreeMap<>();
    List<String> switches = new ArrayList<>();
    for (OwnedDevice device : devices) {
      DeviceSetup setup = device.setup();
      if (setup.gripper().isPresent()
          && layout.script().isPresent()
          && device.owner() == controllers.size() - 1) {
        throw device.place().refusal(text("deviceWithoutArm", setup.name()));
      }
      if (setup.holdsParts()) {
        grippers.put(setup.name(), setup.strokeM());
      }
      if (setup.canBePressed()) {
        switches.add(setup.name());
      }
    }
    List<CellEquipment> each = new ArrayList<>();
    for (int owner = 0; owner < Math.max(1, controllers.size()); owner++) {
      each.add(new CellEquipment(of(owner, devices), List.of()));
    }
    return new EquipmentPlan(
        controllers,
        each,
        RuleReader.read(scene, signals, grippers, switches),
        LayoutReader.wires(scene, layout, signals));
  }

  private static List<DeviceSetup> of(int owner, List<OwnedDevice> devices) {
    return devices.stream().filter(each -> each.owner() == owner).map(OwnedDevice::setup).toList();
  }
}
