/**
 * Devices of the cell: grippers and other things around the arm that answer programs by sockets,
 * remote procedures and signals, in robot time. Open {@link
 * org.pendant.controller.device.CellDevices} first.
 */
package org.pendant.controller.device;
