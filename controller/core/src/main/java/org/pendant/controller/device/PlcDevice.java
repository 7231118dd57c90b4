package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.controller.device.plc.ModbusMemory;
import org.pendant.controller.device.plc.ModbusUnit;
import org.pendant.controller.external.DeviceTalk;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.controller.wire.SignalGroupState;
import org.pendant.controller.wire.SignalOwner;

/** Modbus device: a PLC, or something else that signals of programs reach by Modbus TCP. */
final class PlcDevice implements CellDevice {
  private final DeviceSetup.Modbus setup;
  private final ModbusUnit unit;

  PlcDevice(DeviceSetup.Modbus setup) {
    this.setup = setup;
    ModbusMemory memory = new ModbusMemory(setup.first(), setup.counts());
    setup
        .values()
        .forEach((signal, value) -> memory.line(signal.group(), signal.index()).set(value));
    unit = new ModbusUnit(setup.unit(), memory);
  }

  @Override
  public String name() {
    return setup.name();
  }

  @Override
  public String kind() {
    return text("modbusDevice");
  }

  @Override
  public boolean on() {
    return unit.online();
  }

  @Override
  public String described() {
    return setup.unit().isPresent()
        ? text("modbusDeviceUnit", setup.address(), setup.unit().getAsInt())
        : text("modbusDeviceAt", setup.address());
  }

  @Override
  public OptionalInt port() {
    return setup.port();
  }

  @Override
  public boolean isAt(String host, int port) {
    return (setup.address().host().equalsIgnoreCase(host) && setup.address().port() == port)
        || (OwnAddress.isHost(host) && setup.port().orElse(0) == port);
  }

  /** What answers signals of that address; empty where it is another device's. */
  Optional<ModbusUnit> unit(ModbusAddress address) {
    return isAt(address.host(), address.port()) ? Optional.of(unit) : Optional.empty();
  }

  @Override
  public DeviceTalk connect() {
    return unit.connect();
  }

  @Override
  public Optional<SignalOwner> signals() {
    return Optional.of(unit::line);
  }

  @Override
  public List<SignalGroupState> signalStates() {
    return unit.state();
  }

  @Override
  public boolean putPart(double widthM) {
    return false;
  }

  @Override
  public void step() {
    unit.step();
  }
}
