package org.pendant.command.rpc;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.device.DeviceState;
import org.pendant.models.json.Range;

/** Methods for what stands in the cell and answers programs: grippers, doors, sensors. */
final class CellMethods {
  /** Wider than any gripper opens; the device says what it can hold. */
  private static final Range WIDTH = new Range(0, 10, "m");

  private CellMethods() {}

  static void declareIn(MethodTable table) {
    table.add("devices", List.of(), CellMethods::devices);
    table.add("device.put_part", List.of("device", "width"), CellMethods::putPart);
  }

  private static Object devices(DrivenRobot robot, RpcParams params) {
    return robot.state().devices().stream().map(CellMethods::device).toList();
  }

  private static Map<String, Object> device(DeviceState device) {
    Map<String, Object> told = new LinkedHashMap<>();
    told.put("name", device.name());
    told.put("kind", device.kind());
    told.put("stroke_m", device.strokeM());
    told.put("opening_m", device.openingM());
    told.put("force_n", device.forceN());
    told.put("on", device.on());
    told.put("part_m", device.partM());
    return told;
  }

  private static Object putPart(DrivenRobot robot, RpcParams params) throws RpcFailure {
    String device = params.text("device").orElseThrow(() -> RpcParams.missing("device"));
    OptionalDouble widthM = params.number("width", WIDTH);
    if (widthM.isEmpty()) {
      throw RpcParams.missing("width");
    }
    robot.ask(new WorldCommand.PutPart(device, widthM.getAsDouble()));
    return Map.of();
  }
}
