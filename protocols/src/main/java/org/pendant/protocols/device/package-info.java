/**
 * Ports of the devices of the cell, for clients that talk to them from outside. Open {@link
 * org.pendant.protocols.device.DeviceServer} first.
 */
package org.pendant.protocols.device;
