package org.pendant.protocols.modbusclient;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.controller.external.ModbusConnector;
import org.pendant.controller.external.ModbusExchange;
import org.pendant.controller.external.ModbusPoint;
import org.pendant.controller.external.Pending;
import org.pendant.protocols.egress.HostPolicy;

/**
 * Modbus clients of one controller: connect to its devices; signals at the same address share it.
 */
public final class ModbusClients implements ModbusConnector, AutoCloseable {
  private final HostPolicy hostPolicy;
  private final Map<ModbusAddress, Device> devices = new ConcurrentHashMap<>();

  /** Devices that are no further than {@code reach}. */
  public ModbusClients(HostPolicy hostPolicy) {
    this.hostPolicy = hostPolicy;
  }

  @Override
  public ModbusPoint add(ModbusExchange exchange) {
    while (true) {
      Device device = device(exchange.device());
      Point point = new Point(exchange, device);
      if (device.add(point)) {
        return point;
      }
      devices.remove(exchange.device(), device);
    }
  }

  @Override
  public Pending send(ModbusAddress address, int unit, int function, byte[] data) {
    while (true) {
      Device device = device(address);
      CustomCommand command = new CustomCommand(DeviceRequest.made(unit, function, data), device);
      if (device.add(command)) {
        return command;
      }
      devices.remove(address, device);
    }
  }

  private Device device(ModbusAddress address) {
    return devices.computeIfAbsent(
        address, each -> new Device(each, hostPolicy, gone -> devices.remove(each, gone)));
  }

  /** Ends all signals, and waits until what was set has been written, a few seconds at most. */
  @Override
  public void close() {
    List<Device> left = List.copyOf(devices.values());
    left.forEach(Device::close);
    left.forEach(Device::awaitEnd);
  }
}
