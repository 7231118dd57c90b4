package org.pendant.protocols.rtde;

import java.nio.ByteBuffer;

/**
 * RTDE package as it comes: a size of two bytes that counts itself, a type of one byte, the rest.
 *
 * @param type a letter, see {@link PacketType}; others are possible
 * @param payload big-endian, between position and limit
 */
record Packet(int type, ByteBuffer payload) {
  /** Size and type. */
  static final int HEADER_BYTES = 3;

  /** The size has two bytes. */
  static final int MAX_BYTES = 0xFFFF;
}
