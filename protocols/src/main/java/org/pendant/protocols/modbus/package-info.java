/**
 * Modbus TCP server (port 502): the box's signals, the memory that scripts share with Modbus
 * clients, and the arm's state, as registers and bits. Open {@link
 * org.pendant.protocols.modbus.ModbusServer} first.
 */
package org.pendant.protocols.modbus;
