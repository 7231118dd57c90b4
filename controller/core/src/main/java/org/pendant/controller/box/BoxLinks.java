package org.pendant.controller.box;

import org.pendant.controller.device.CellDevices;
import org.pendant.controller.eip.Assemblies;
import org.pendant.controller.external.Connectors;
import org.pendant.controller.external.ExternalConnections;
import org.pendant.controller.io.InputWatchdogs;
import org.pendant.controller.io.Signals;
import org.pendant.controller.message.MessageLog;
import org.pendant.controller.modbus.ModbusSignals;
import org.pendant.controller.rule.Rules;

/**
 * External links of the box to other computers and devices: connections that programs open, and
 * what clients write and read.
 */
public final class BoxLinks {
  private final CellDevices devices;
  private final Rules rules;
  private final ExternalConnections outside;
  private final ModbusSignals modbus;
  private final ToolSerialInterface toolLine;
  private final InputWatchdogs inputWatchdogs = new InputWatchdogs();
  private final Assemblies assemblies = new Assemblies();
  private Published published = Published.NOTHING;

  /** What rules do to devices. */
  private record OwnDeviceActions(CellDevices devices) implements Rules.DeviceActions {
    @Override
    public void putPart(String gripper, double widthM) {
      devices.putPart(gripper, widthM);
    }

    @Override
    public void press(String device, boolean pressed) {
      devices.press(device, pressed);
    }
  }

  BoxLinks(
      CellEquipment equipment,
      CellDevices devices,
      Connectors connectors,
      Signals signals,
      MessageLog log) {
    this.devices = devices;
    rules = new Rules(equipment.rules(), devices.lines(), new OwnDeviceActions(devices));
    Connectors all = devices.before(connectors);
    outside = new ExternalConnections(all);
    modbus = new ModbusSignals(all.modbus(), log);
    signals.runState().lead(modbus::follow);
    toolLine = new ToolSerialInterface(connectors.toolSerial(), signals, log);
  }

  /** The devices of the cell. */
  public CellDevices devices() {
    return devices;
  }

  /** Has the cell answer what was sent and set in the frame before, once a frame. */
  public void stepCell() {
    devices.step();
    rules.step();
  }

  /** The connections of programs to other computers. */
  public ExternalConnections outside() {
    return outside;
  }

  /** The Modbus signals that programs have added. */
  public ModbusSignals modbus() {
    return modbus;
  }

  /** The serial line of the tool connector. */
  public ToolSerialInterface toolLine() {
    return toolLine;
  }

  /** Who watches that inputs are written often enough. */
  public InputWatchdogs inputWatchdogs() {
    return inputWatchdogs;
  }

  /** What programs exchange with an EtherNet/IP scanner. */
  public Assemblies assemblies() {
    return assemblies;
  }

  /** What the controller told the world at the end of the frame before. */
  public Published published() {
    return published;
  }

  /** From now on programs read there what the controller tells the world. */
  public void setPublished(Published source) {
    published = source;
  }

  /** A program has ended, and with it what it expected of clients. */
  void programStopped() {
    inputWatchdogs.clear();
    assemblies.programEnded();
  }
}
