/**
 * What PLCs of the cell are made of: the memory of a Modbus device, and what it answers. Open
 * {@link org.pendant.controller.device.plc.ModbusMemory} first.
 */
package org.pendant.controller.device.plc;
