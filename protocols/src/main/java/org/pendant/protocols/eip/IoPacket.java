package org.pendant.protocols.eip;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Optional;

/**
 * I/O packet: one packet of cyclic data (CIP volume 2, 3-2).
 *
 * @param connection number of the direction of a connection
 * @param number counts the packets of a connection
 * @param dataNumber counts what is new in them
 * @param data little-endian: for the target 32 bits of which the lowest says whether the scanner
 *     runs, then an assembly; for the originator just the assembly
 */
record IoPacket(int connection, int number, int dataNumber, ByteBuffer data) {
  /** The packet that a datagram holds; empty when it is something else. */
  static Optional<IoPacket> decode(ByteBuffer datagram) {
    return PacketItem.decode(datagram).flatMap(IoPacket::of);
  }

  private static Optional<IoPacket> of(List<PacketItem> items) {
    if (items.size() != 2
        || items.get(0).type() != PacketItem.SEQUENCED_ADDRESS
        || items.get(0).data().remaining() != 8
        || items.get(1).type() != PacketItem.CONNECTED_DATA
        || items.get(1).data().remaining() < 2) {
      return Optional.empty();
    }
    ByteBuffer address = items.get(0).data();
    ByteBuffer data = items.get(1).data();
    int dataNumber = Short.toUnsignedInt(data.getShort());
    return Optional.of(
        new IoPacket(
            address.getInt(),
            address.getInt(),
            dataNumber,
            data.slice().order(ByteOrder.LITTLE_ENDIAN)));
  }

  /** The bytes of the datagram. */
  byte[] encode() {
    ByteBuffer bytes = ByteBuffer.allocate(20 + data.remaining()).order(ByteOrder.LITTLE_ENDIAN);
    bytes.putShort((short) 2).putShort((short) PacketItem.SEQUENCED_ADDRESS).putShort((short) 8);
    bytes.putInt(connection).putInt(number);
    bytes.putShort((short) PacketItem.CONNECTED_DATA).putShort((short) (data.remaining() + 2));
    return bytes.putShort((short) dataNumber).put(data.duplicate()).array();
  }
}
