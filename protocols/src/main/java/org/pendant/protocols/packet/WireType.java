package org.pendant.protocols.packet;

/**
 * Wire type: how a number stands in a packet. Whole numbers lose the bits above those that they
 * have.
 */
public enum WireType {
  INT8(1),
  INT16(2),
  INT32(4),
  INT64(8),
  FLOAT32(4),
  FLOAT64(8);

  private final int bytes;

  WireType(int bytes) {
    this.bytes = bytes;
  }

  /** How many bytes a number takes. */
  public int bytes() {
    return bytes;
  }
}
