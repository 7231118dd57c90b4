package org.pendant.controller;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.pendant.controller.device.CellDevices;
import org.pendant.controller.device.DeviceState;
import org.pendant.controller.rule.Rules;

/** Device actions of a cell: what its rules do to devices, whichever controller has them. */
final class CellDeviceActions implements Rules.DeviceActions {
  private final Map<String, CellDevices> devices = new HashMap<>();

  CellDeviceActions(List<Cell.Member> members) {
    for (Cell.Member member : members) {
      CellDevices of = member.controller().box().links().devices();
      for (DeviceState each : of.states()) {
        devices.put(each.name(), of);
      }
    }
  }

  @Override
  public void putPart(String gripper, double widthM) {
    devices.get(gripper).putPart(gripper, widthM);
  }

  @Override
  public void press(String device, boolean pressed) {
    devices.get(device).press(device, pressed);
  }
}
