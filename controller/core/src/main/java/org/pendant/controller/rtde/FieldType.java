package org.pendant.controller.rtde;

/** The type of a field that is exchanged by RTDE; values are big-endian and lie close together. */
public enum FieldType {
  BOOL(1),
  UINT8(1),
  UINT32(4),
  UINT64(8),
  INT32(4),
  DOUBLE(8),
  VECTOR3D(24),
  VECTOR6D(48),
  VECTOR6INT32(24),
  VECTOR6UINT32(24);

  private final int bytes;

  FieldType(int bytes) {
    this.bytes = bytes;
  }

  /** How many bytes a value takes. */
  public int bytes() {
    return bytes;
  }
}
