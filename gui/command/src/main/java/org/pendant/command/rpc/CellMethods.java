package org.pendant.command.rpc;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.device.DeviceState;
import org.pendant.controller.wire.SignalGroupState;
import org.pendant.models.json.Range;

/** Methods for what stands in the cell and answers programs: grippers, doors, sensors. */
final class CellMethods {
  /** Wider than any gripper opens; the device says what it can hold. */
  private static final Range WIDTH = new Range(0, 10, "m");

  /** More than any signal can be; its group says what it can. */
  private static final Range VALUE = new Range(Integer.MIN_VALUE, Integer.MAX_VALUE, "");

  private CellMethods() {}

  static void declareIn(MethodTable table) {
    table.add("devices", List.of(), CellMethods::devices);
    table.add("device.put_part", List.of("device", "width"), CellMethods::putPart);
    table.add("device.set_signal", List.of("signal", "value"), CellMethods::setSignal);
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
    told.put("part_m", device.partWidthM());
    told.put("signals", signals(device));
    return told;
  }

  private static Map<String, Integer> signals(DeviceState device) {
    Map<String, Integer> values = new LinkedHashMap<>();
    for (SignalGroupState group : device.signals()) {
      for (int i = 0; i < group.values().size(); i++) {
        values.put(group.name() + "[" + (group.first() + i) + "]", group.values().get(i));
      }
    }
    return values;
  }

  private static Object setSignal(DrivenRobot robot, RpcParams params) throws RpcFailure {
    String signal = params.text("signal").orElseThrow(() -> RpcParams.missing("signal"));
    OptionalDouble value = params.number("value", VALUE);
    if (value.isEmpty()) {
      throw RpcParams.missing("value");
    }
    robot.ask(new WorldCommand.SetSignal(signal, (int) value.getAsDouble()));
    return Map.of();
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
