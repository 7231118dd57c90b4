package org.pendant.protocols.eip;

/**
 * Connection parameters: how data are sent in one direction of a connection (CIP volume 1,
 * 3-5.5.1.1).
 *
 * @param bytes size of a packet's data with the numbers in front
 * @param variable whether packets may be shorter
 */
record ConnectionParameters(int bytes, boolean variable, Type type) {
  /** Whom they go to. */
  enum Type {
    NONE,
    MULTICAST,
    POINT_TO_POINT,
    RESERVED
  }

  /** From the 16 bits of a Forward_Open. */
  static ConnectionParameters ofShort(int bits) {
    return new ConnectionParameters(bits & 0x1FF, (bits >> 9 & 1) != 0, type(bits >> 13));
  }

  /** From the 32 bits of a Large_Forward_Open. */
  static ConnectionParameters ofLong(int bits) {
    return new ConnectionParameters(bits & 0xFFFF, (bits >> 25 & 1) != 0, type(bits >> 29));
  }

  private static Type type(int bits) {
    return switch (bits & 3) {
      case 0 -> Type.NONE;
      case 1 -> Type.MULTICAST;
      case 2 -> Type.POINT_TO_POINT;
      default -> Type.RESERVED;
    };
  }
}
