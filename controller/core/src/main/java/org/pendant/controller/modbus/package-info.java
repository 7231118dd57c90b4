/**
 * Modbus signals that programs add: what they are worth, how long they have not been valid, and
 * what follows from them. Open {@link org.pendant.controller.modbus.ModbusSignals} first; devices
 * are spoken to elsewhere.
 */
package org.pendant.controller.modbus;
