/**
 * Modbus client of scripts: one connection a device, on virtual threads, with j2mod's messages.
 * Open {@link org.pendant.protocols.modbusclient.ModbusClients} first; what scripts make of the
 * values is the controller's business.
 */
package org.pendant.protocols.modbusclient;
