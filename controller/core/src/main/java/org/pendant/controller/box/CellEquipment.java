package org.pendant.controller.box;

import static org.pendant.controller.box.BoxTexts.text;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.pendant.controller.device.CellDevices;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.rule.RuleSetup;
import org.pendant.models.json.Json;

/**
 * Equipment of a cell: what in it answers the program.
 *
 * @param devices at most {@value CellDevices#MAX}, each with its own name
 * @param rules what happens by itself, in their order
 * @param controllers what files call the controllers of the cell, whose first one it is for; none
 *     where there is one alone
 */
public record CellEquipment(
    List<DeviceSetup> devices, List<RuleSetup> rules, List<String> controllers) {
  /** Nothing. */
  public static final CellEquipment NONE = new CellEquipment(List.of(), List.of());

  /** That of a controller that is alone. */
  public CellEquipment(List<DeviceSetup> devices, List<RuleSetup> rules) {
    this(devices, rules, List.of());
  }

  /**
   * Checks count and names.
   *
   * @throws IllegalArgumentException for too many devices, and for two of one name
   */
  public CellEquipment {
    devices = List.copyOf(devices);
    rules = List.copyOf(rules);
    controllers = List.copyOf(controllers);
    if (devices.size() > CellDevices.MAX) {
      throw new IllegalArgumentException(text("devices", devices.size(), CellDevices.MAX));
    }
    Set<String> names = new HashSet<>();
    for (DeviceSetup device : devices) {
      if (!names.add(device.name())) {
        throw new IllegalArgumentException(text("nameAgain", Json.quoted(device.name())));
      }
    }
  }

  /**
   * With more devices.
   *
   * @throws IllegalArgumentException for two of one name, and too many
   */
  public CellEquipment and(List<DeviceSetup> more) {
    return more.isEmpty()
        ? this
        : new CellEquipment(
            Stream.concat(devices.stream(), more.stream()).toList(), rules, controllers);
  }
}
