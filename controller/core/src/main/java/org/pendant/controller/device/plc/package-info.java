/**
 * What PLCs of the cell are made of: the memory of a Modbus device, and what it answers, and a
 * scanner of the EtherNet/IP adapter. Open {@link org.pendant.controller.device.plc.ModbusMemory}
 * first.
 */
package org.pendant.controller.device.plc;
