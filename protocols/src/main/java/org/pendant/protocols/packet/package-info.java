/**
 * Packets whose numbers have fixed places, made from the controller's catalogue of state quantities
 * without allocating anything but the packet. Open {@link
 * org.pendant.protocols.packet.PacketLayout} first.
 */
package org.pendant.protocols.packet;
