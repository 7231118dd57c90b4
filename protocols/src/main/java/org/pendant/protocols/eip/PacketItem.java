package org.pendant.protocols.eip;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Packet item: one item of the common packet format (CIP volume 2, 2-6).
 *
 * @param type what it is
 * @param data little-endian, from position to limit
 */
record PacketItem(int type, ByteBuffer data) {
  /** No address. */
  static final int NO_ADDRESS = 0x0000;

  /** Who answers to ListIdentity. */
  static final int IDENTITY = 0x000C;

  /** A connection by its number. */
  static final int CONNECTED_ADDRESS = 0x00A1;

  /** Data of a connection. */
  static final int CONNECTED_DATA = 0x00B1;

  /** A message without a connection. */
  static final int UNCONNECTED_DATA = 0x00B2;

  /** What an adapter can do. */
  static final int SERVICE = 0x0100;

  /** Where data from originator to target go. */
  static final int SOCKET_TO_TARGET = 0x8000;

  /** Where data from target to originator go. */
  static final int SOCKET_TO_ORIGINATOR = 0x8001;

  /** A connection by its number, with the number of the packet. */
  static final int SEQUENCED_ADDRESS = 0x8002;

  /** More are never needed. */
  private static final int MAX_ITEMS = 8;

  /** The items of a message; empty when it is not made of items from begin to end. */
  static Optional<List<PacketItem>> decode(ByteBuffer bytes) {
    ByteBuffer in = bytes.slice().order(ByteOrder.LITTLE_ENDIAN);
    if (in.remaining() < 2) {
      return Optional.empty();
    }
    int count = Short.toUnsignedInt(in.getShort());
    if (count > MAX_ITEMS) {
      return Optional.empty();
    }
    List<PacketItem> items = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      if (in.remaining() < 4) {
        return Optional.empty();
      }
      int type = Short.toUnsignedInt(in.getShort());
      int length = Short.toUnsignedInt(in.getShort());
      if (length > in.remaining()) {
        return Optional.empty();
      }
      items.add(
          new PacketItem(type, in.slice(in.position(), length).order(ByteOrder.LITTLE_ENDIAN)));
      in.position(in.position() + length);
    }
    return in.hasRemaining() ? Optional.empty() : Optional.of(items);
  }

  /** Adds a message of these items. */
  static LittleEndian encode(LittleEndian out, List<PacketItem> items) {
    out.u16(items.size());
    for (PacketItem item : items) {
      out.u16(item.type()).u16(item.data().remaining()).bytes(item.data());
    }
    return out;
  }

  /** The first item of a type. */
  static Optional<PacketItem> first(List<PacketItem> items, int type) {
    return items.stream().filter(item -> item.type() == type).findFirst();
  }
}
