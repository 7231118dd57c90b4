package org.pendant.controller.installation;

import org.pendant.controller.external.ModbusKind;

/**
 * Modbus signal that is exchanged with a device as long as the controller is on.
 *
 * @param name its own among all signals
 * @param device address, as {@code 192.168.0.10} or {@code 127.0.0.1:1502}
 * @param unit which one behind that address, 0 to 255
 * @param kind digital or register, in or out
 * @param address of the coil, input or register, from 0
 * @param updateHz how often it is exchanged
 */
public record ModbusSetup(
    String name, String device, int unit, ModbusKind kind, int address, int updateHz) {}
