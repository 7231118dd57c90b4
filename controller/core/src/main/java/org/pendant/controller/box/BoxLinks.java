package org.pendant.controller.box;

import org.pendant.controller.eip.Assemblies;
import org.pendant.controller.external.Connectors;
import org.pendant.controller.external.ExternalConnections;
import org.pendant.controller.io.InputWatchdogs;
import org.pendant.controller.io.Signals;
import org.pendant.controller.message.MessageLog;
import org.pendant.controller.modbus.ModbusSignals;

/**
 * External links of the box to other computers and devices: connections that programs open, and
 * what clients write and read.
 */
public final class BoxLinks {
  private final ExternalConnections outside;
  private final ModbusSignals modbus;
  private final ToolSerialInterface toolLine;
  private final InputWatchdogs inputWatchdogs = new InputWatchdogs();
  private final Assemblies assemblies = new Assemblies();
  private Published published = Published.NOTHING;

  BoxLinks(Connectors connectors, Signals signals, MessageLog log) {
    outside = new ExternalConnections(connectors);
    modbus = new ModbusSignals(connectors.modbus(), log);
    signals.runState().lead(modbus::follow);
    toolLine = new ToolSerialInterface(connectors.toolSerial(), signals, log);
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
